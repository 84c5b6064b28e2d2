//! The macro of the crate `ptc`: tokens, and a design file, to a spec, the spec to code, the code to tokens.

mod design;
mod errors;
mod input;

use proc_macro2::TokenStream;
use ptc_codegen::diagnostic::Diagnostic;
use ptc_codegen::{macro_items, plant};

#[allow(missing_docs)] // Told where users meet it, at the re-export of `ptc`.
#[proc_macro]
pub fn ptc_controller(tokens: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand(tokens.into()).into()
}

fn expand(tokens: TokenStream) -> TokenStream {
    let input = input::read(tokens);
    let items = match plant::read_design(&input.entries) {
        Ok((spec, _)) if input.wrong.is_empty() => macro_items(&spec).and_then(|text| lex(&text)),
        Ok(_) => Err(Vec::new()),
        Err(found) => Err(found),
    };
    let mut items = items.unwrap_or_else(|found| errors::tokens(&input, found));
    items.extend(input.design.iter().flat_map(|design| design.tracked()));
    items
}

fn lex(text: &str) -> Result<TokenStream, Vec<Diagnostic>> {
    text.parse().map_err(|error| {
        vec![Diagnostic {
            code: "internal",
            key: String::new(),
            place: None,
            message: format!("the generated code is no Rust: {error}"),
            help: "this is a fault of the generator".to_owned(),
        }]
    })
}
