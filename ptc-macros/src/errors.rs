//! Diagnostics as compile errors at the tokens that are wrong.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use ptc_codegen::design::independent;
use ptc_codegen::diagnostic::{Diagnostic, Place, first, visible};
use ptc_codegen::family::FAMILIES;
use ptc_codegen::parameter;
use ptc_codegen::request::{Entry, Spec};
use ptc_codegen::syntax::Value;

use crate::input::{Input, Spot, example};

/// One compile error for each mistake in `input` and each in `found`, in the order in which they
/// were written.
pub(crate) fn tokens(input: &Input, found: Vec<Diagnostic>) -> TokenStream {
    let mut found = independent(&input.wrong, &input.entries, found);
    // The file may hold what seems to be missing.
    let no_file = input.wrong.iter().any(|wrong| wrong.key == "file");
    found.retain(|wrong| wrong.code != "missing-key" || !no_file);
    found.extend(input.wrong.iter().cloned());
    found.sort_by_key(|wrong| (wrong.place.is_none(), wrong.place));
    let found = first(found);
    let errors = found.iter().flat_map(|wrong| {
        let place = wrong.place.or_else(|| value_of(input, &wrong.key));
        let spot = place.and_then(|place| input.places.get(place.0));
        let (spans, message) = match (spot, &input.design) {
            (Some(Spot::File(range)), Some(design)) => {
                let message = design.told(range.clone(), &wrong.message);
                (Some((design.span, design.span)), message)
            }
            (Some(Spot::Tokens(first, last)), _) => (Some((*first, *last)), wrong.message.clone()),
            _ => (None, wrong.message.clone()),
        };
        let example = match wrong.code {
            "missing-key" => format!(", for example {}", example(&wrong.key)),
            _ => String::new(),
        };
        let text = format!("[{}] {message}\nhelp: {}{example}", wrong.code, wrong.help);
        compile_error(spans, &visible(&text))
    });
    let errors = errors.collect();
    let named = found.iter().all(|wrong| wrong.key != "name");
    match type_name(input).filter(|_| named) {
        Some(name) => beside_stub(&name, errors),
        None => errors,
    }
}

/// The place of the value of a key, for errors in what follows from it.
fn value_of(input: &Input, key: &str) -> Option<Place> {
    let called = |entry: &&Entry| entry.key.rsplit('.').next() == Some(key);
    input.entries.iter().find(called).map(|entry| entry.value.place)
}

/// `::core::compile_error! { "message" }`. The compiler marks all from the span of its first token
/// to that of its last.
fn compile_error(spans: Option<(Span, Span)>, message: &str) -> TokenStream {
    let (first, last) = spans.unwrap_or((Span::call_site(), Span::call_site()));
    let colon = |spacing| TokenTree::from(Punct::new(':', spacing));
    let word = |text| TokenTree::from(Ident::new(text, first));
    let text = TokenTree::from(Literal::string(message));
    let mut tokens = [
        colon(Spacing::Joint),
        colon(Spacing::Alone),
        word("core"),
        colon(Spacing::Joint),
        colon(Spacing::Alone),
        word("compile_error"),
        Punct::new('!', Spacing::Alone).into(),
        Group::new(Delimiter::Brace, text.into()).into(),
    ];
    for token in &mut tokens {
        token.set_span(first);
    }
    let [.., group] = &mut tokens;
    group.set_span(last);
    tokens.into_iter().collect()
}

/// The errors in a module from which the controller's two names are imported: the compiler knows
/// that a module with such an error is not whole, and says nothing of what it lacks, nor of the
/// code that uses it.
fn beside_stub(name: &str, errors: TokenStream) -> TokenStream {
    let stub = format!(
        "#[allow(non_snake_case)] mod __{name} {{}} \
         #[allow(unused_imports)] pub use __{name}::{{{name}, {name}Params}};"
    );
    let Ok(stub) = stub.parse::<TokenStream>() else { return errors };
    let mut body = Some(errors);
    let fill = |tree| match tree {
        // The first braces are those of the module.
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
            Group::new(Delimiter::Brace, body.take().unwrap_or_else(|| group.stream())).into()
        }
        other => other,
    };
    stub.into_iter().map(fill).collect()
}

/// Name of the controller's type, if the entries give it.
fn type_name(input: &Input) -> Option<String> {
    let value = |key| input.entries.iter().find(|entry| entry.key == key).map(|e| &e.value.value);
    let name = match (value("name"), value("mu"), value("n")) {
        (Some(Value::Word(name)), ..) => name.clone(),
        (None, Some(Value::Word(mu) | Value::Call(mu, _)), Some(Value::Number(n))) => {
            let info = FAMILIES.iter().find(|info| info.name == *mu)?;
            Spec::new(n.to_string().parse().ok()?, info.family).name()
        }
        _ => return None,
    };
    Some(parameter::type_name(&name))
}
