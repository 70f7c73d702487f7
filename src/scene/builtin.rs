//! The built-in scenes.

use super::Scene;

/// A built-in scene, by name.
pub struct BuiltIn {
    /// The name by which the command knows it.
    pub name: &'static str,
    /// One line on what it is for.
    pub about: &'static str,
    /// Makes it.
    pub make: fn() -> Scene,
}

/// All built-in scenes.
pub fn builtins() -> Vec<BuiltIn> {
    Vec::new()
}

/// The built-in scene of this name.
pub fn built_in(name: &str) -> Option<Scene> {
    builtins().iter().find(|b| b.name == name).map(|b| (b.make)())
}
