//! The labs of *Light, Patch by Patch*.
