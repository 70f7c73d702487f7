//! Figures, examples and gates of the book *Light, Patch by Patch*.
