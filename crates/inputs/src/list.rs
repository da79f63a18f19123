//! Lists in which each name stands once, with everything that is said of it.

/// Defines an enum of names, each with its constant of what is said of it.
#[doc(hidden)]
#[macro_export]
macro_rules! listed {
    ($(#[$meta:meta])* $name:ident: $info:ty; $($variant:ident = $said:expr;)*) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        #[allow(missing_docs, reason = "the words stand in the list")]
        pub enum $name {
            $($variant,)*
        }

        impl $name {
            /// All of them, in the order of the list.
            pub const ALL: &'static [$name] = &[$($name::$variant,)*];

            /// Entry of the name in the list.
            pub const fn info(self) -> &'static $info {
                match self {
                    $($name::$variant => {
                        const INFO: $info = $said;
                        &INFO
                    })*
                }
            }
        }
    };
}
