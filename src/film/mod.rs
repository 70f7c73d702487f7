//! Placeholder header, to be replaced by the module.
