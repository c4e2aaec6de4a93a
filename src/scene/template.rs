//! The sidecar template, `NAME.template.json`: what is declared before the program runs. Every mistake is told at its place.

use std::collections::HashMap;

use jsonc_parser::ast::{Object, ObjectProp, Value};
use jsonc_parser::common::{Range, Ranged};
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};
use ruff_text_size::{TextRange, TextSize};

use crate::trace::Plain;

use super::error::SceneError;
use super::origin::{Origin, Source};
use super::terms::{Given, Kind, ObjectId, Scalar, Support};
use super::world::{MAX_OBJECTS, NewObject, World, color_of};

/// A template that can be declared.
#[derive(Clone, PartialEq, Debug)]
pub struct Template {
    /// The title; empty if none is given.
    pub title: String,
    /// Width, depth, height of the scene.
    pub dims: [Scalar; 3],
    /// Whether there is a ceiling.
    pub interior: bool,
    /// What it declares, in order.
    pub objects: Vec<TemplateObject>,
    /// What is likely to be wrong, but does not keep it from being used.
    pub warnings: Vec<TemplateError>,
}

/// One entry of `objects`.
#[derive(Clone, PartialEq, Debug)]
pub struct TemplateObject {
    /// The variable that it becomes.
    pub id: String,
    /// The name; a trailing number is dropped.
    pub name: String,
    /// Object, door or window.
    pub kind: Kind,
    /// Width, depth, height.
    pub dims: [Scalar; 3],
    /// What holds it up.
    pub support: Support,
    /// RRGGBB.
    pub color: Option<String>,
    /// Whether physics may move it.
    pub dynamic: bool,
    /// With a count, the variable is a list of so many.
    pub count: Option<usize>,
    /// The entry, in bytes of the JSON.
    pub range: TextRange,
    /// Its id, in bytes of the JSON.
    pub id_range: TextRange,
}

/// Something wrong at a place of the JSON.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TemplateError {
    /// Where, in bytes.
    pub range: TextRange,
    /// What.
    pub message: String,
}

/// What a variable of the template stands for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Declared {
    /// An object.
    One(ObjectId),
    /// A list of objects.
    Many(Vec<ObjectId>),
}

/// Python's keywords: no variable has these names.
pub const KEYWORDS: [&str; 35] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue", "def", "del", "elif", "else", "except",
    "finally", "for", "from", "global", "if", "import", "in", "is", "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try",
    "while", "with", "yield",
];

const SCENE_KEYS: [&str; 6] = ["title", "width", "depth", "height", "interior", "objects"];
const OBJECT_KEYS: [&str; 10] = ["id", "name", "width", "depth", "height", "support", "color", "kind", "dynamic", "count"];

fn range_of(range: Range) -> TextRange {
    let offset = |at: usize| TextSize::new(u32::try_from(at).unwrap_or(u32::MAX));
    TextRange::new(offset(range.start), offset(range.end.max(range.start)))
}

fn is_identifier(text: &str) -> bool {
    let mut chars = text.chars();
    let starts = chars.next().is_some_and(|first| first == '_' || unicode_ident::is_xid_start(first));
    starts && chars.all(unicode_ident::is_xid_continue)
}

/// Whether a text can be the name of a variable as it stands: Python takes some letters for others.
pub fn is_variable_name(text: &str) -> bool {
    is_identifier(text) && unicode_normalization::is_nfkc(text) && !KEYWORDS.contains(&text)
}

/// JSON as RFC 8259 has it: no comments, no trailing commas.
pub(crate) const STRICT: ParseOptions = ParseOptions {
    allow_comments: false,
    allow_loose_object_property_names: false,
    allow_trailing_commas: false,
    allow_missing_commas: false,
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// Reads a template. JSON as RFC 8259 has it: no comments, no trailing commas.
pub fn parse(text: &str) -> Result<Template, Vec<TemplateError>> {
    if u32::try_from(text.len()).is_err() {
        return Err(vec![TemplateError { range: TextRange::default(), message: "the template is too large".into() }]);
    }
    // A byte order mark becomes white space of the same length, so that places stay what they are.
    let marked = text.strip_prefix('\u{feff}').map(|rest| format!("   {rest}"));
    let parsed = parse_to_ast(marked.as_deref().unwrap_or(text), &CollectOptions::default(), &STRICT);
    let mut reader = Reader::default();
    let template = match parsed.map(|result| result.value) {
        Err(error) => {
            reader.error(error.range(), format!("this is no JSON: {}", lower_first(&error.kind().to_string())));
            None
        }
        Ok(Some(Value::Object(scene))) => reader.scene(&scene),
        Ok(Some(other)) => {
            reader.error(other.range(), format!("a template is an object, not {}", kind_of(&other)));
            None
        }
        Ok(None) => {
            reader.error(Range::new(0, text.len()), "the template is empty".into());
            None
        }
    };
    match template {
        Some(template) if reader.errors.is_empty() => Ok(Template { warnings: reader.warnings, ..template }),
        _ => Err(reader.errors),
    }
}

fn lower_first(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or(String::new(), |first| first.to_lowercase().chain(chars).collect())
}

/// What a value of JSON is, for messages.
pub(crate) fn kind_of(value: &Value) -> &'static str {
    match value {
        Value::StringLit(_) => "a string",
        Value::NumberLit(_) => "a number",
        Value::BooleanLit(_) => "true or false",
        Value::Object(_) => "an object",
        Value::Array(_) => "a list",
        Value::NullKeyword(_) => "null",
    }
}

/// Reads values and remembers what is wrong with them.
#[derive(Default)]
struct Reader {
    errors: Vec<TemplateError>,
    warnings: Vec<TemplateError>,
    /// Where each id stands first.
    ids: HashMap<String, Range>,
    total: usize,
}

/// The properties of an object by name; a name that stands twice or means nothing is told.
type Fields<'a, 'b> = HashMap<&'b str, &'b ObjectProp<'a>>;

impl Reader {
    fn error(&mut self, range: Range, message: String) {
        self.errors.push(TemplateError { range: range_of(range), message });
    }

    fn fields<'a, 'b>(&mut self, object: &'b Object<'a>, known: &[&str]) -> Fields<'a, 'b> {
        let mut fields = Fields::new();
        for property in &object.properties {
            let name = property.name.as_str();
            let range = property.name.range();
            if !known.contains(&name) {
                let message = format!("{name:?} means nothing here; known are {}", known.join(", "));
                self.warnings.push(TemplateError { range: range_of(range), message });
            } else if fields.insert(name, property).is_some() {
                self.error(range, format!("{name:?} stands twice"));
            }
        }
        fields
    }

    fn required<'a, 'b>(&mut self, fields: &Fields<'a, 'b>, key: &str, owner: Range) -> Option<&'b Value<'a>> {
        let found = fields.get(key).map(|property| &property.value);
        if found.is_none() {
            self.error(Range::new(owner.start, owner.start + 1), format!("{key:?} is missing"));
        }
        found
    }

    /// A value that may be left out, or null.
    fn optional<'a, 'b>(fields: &Fields<'a, 'b>, key: &str) -> Option<&'b Value<'a>> {
        fields.get(key).map(|property| &property.value).filter(|value| !matches!(value, Value::NullKeyword(_)))
    }

    fn text(&mut self, value: &Value, key: &str) -> Option<String> {
        if let Value::StringLit(text) = value {
            return Some(text.value.to_string());
        }
        self.error(value.range(), format!("{key:?} is a string, not {}", kind_of(value)));
        None
    }

    fn truth(&mut self, value: Option<&Value>, key: &str, default: bool) -> bool {
        match value {
            None => default,
            Some(Value::BooleanLit(truth)) => truth.value,
            Some(other) => {
                self.error(other.range(), format!("{key:?} is true or false, not {}", kind_of(other)));
                default
            }
        }
    }

    fn size(&mut self, value: &Value, key: &str) -> Option<Scalar> {
        let Value::NumberLit(number) = value else {
            self.error(value.range(), format!("{key:?} is a number, not {}", kind_of(value)));
            return None;
        };
        let int = !number.value.contains(['.', 'e', 'E']);
        match number.value.parse::<f64>() {
            Ok(size) if size.is_finite() && size > 0.0 => Some(Scalar { int, ..Scalar::float(size) }),
            _ => {
                self.error(number.range, format!("{key:?} must be positive and finite, not {}", number.value));
                None
            }
        }
    }

    fn sizes(&mut self, fields: &Fields, owner: Range) -> Option<[Scalar; 3]> {
        let [width, depth, height] = ["width", "depth", "height"].map(|key| {
            let value = self.required(fields, key, owner)?;
            self.size(value, key)
        });
        Some([width?, depth?, height?])
    }

    fn scene(&mut self, scene: &Object) -> Option<Template> {
        let fields = self.fields(scene, &SCENE_KEYS);
        let title = Self::optional(&fields, "title").and_then(|value| self.text(value, "title")).unwrap_or_default();
        let dims = self.sizes(&fields, scene.range);
        let interior = self.truth(Self::optional(&fields, "interior"), "interior", true);
        let objects = match self.required(&fields, "objects", scene.range) {
            Some(Value::Array(list)) => list.elements.iter().filter_map(|entry| self.entry(entry)).collect(),
            Some(other) => {
                self.error(other.range(), format!("\"objects\" is a list, not {}", kind_of(other)));
                Vec::new()
            }
            None => Vec::new(),
        };
        Some(Template { title, dims: dims?, interior, objects, warnings: Vec::new() })
    }

    fn entry(&mut self, entry: &Value) -> Option<TemplateObject> {
        let Value::Object(object) = entry else {
            self.error(entry.range(), format!("an entry of \"objects\" is an object, not {}", kind_of(entry)));
            return None;
        };
        let fields = self.fields(object, &OBJECT_KEYS);
        let id = self.required(&fields, "id", object.range).and_then(|value| Some((self.id(value)?, range_of(value.range()))));
        let name = self.required(&fields, "name", object.range).and_then(|value| self.text(value, "name"));
        let dims = self.sizes(&fields, object.range);
        let kind = Self::optional(&fields, "kind").map_or(Some(Kind::Object), |value| self.kind(value));
        let support = Self::optional(&fields, "support").map_or(Some(Support::Standing), |value| self.support(value));
        let color = Self::optional(&fields, "color").and_then(|value| self.color(value));
        let dynamic = self.truth(Self::optional(&fields, "dynamic"), "dynamic", false);
        let count = Self::optional(&fields, "count").map_or(Some(None), |value| self.count(value).map(Some))?;
        self.total = self.total.saturating_add(count.unwrap_or(1));
        if self.total > MAX_OBJECTS {
            self.error(object.range, format!("a scene holds at most {MAX_OBJECTS} objects"));
            return None;
        }
        let (id, id_range) = id?;
        Some(TemplateObject {
            id,
            name: name?,
            kind: kind?,
            dims: dims?,
            support: support?,
            color,
            dynamic,
            count,
            range: range_of(object.range),
            id_range,
        })
    }

    fn id(&mut self, value: &Value) -> Option<String> {
        let id = self.text(value, "id")?;
        let range = value.range();
        if !is_identifier(&id) {
            self.error(range, format!("{id:?} is no name for a variable"));
            return None;
        }
        if KEYWORDS.contains(&id.as_str()) {
            self.error(range, format!("{id:?} is a keyword of Python and no name for a variable"));
            return None;
        }
        if self.ids.insert(id.clone(), range).is_some() {
            self.error(range, format!("the id {id:?} stands twice"));
            return None;
        }
        Some(id)
    }

    fn kind(&mut self, value: &Value) -> Option<Kind> {
        let text = self.text(value, "kind")?;
        let kind = [Kind::Object, Kind::Door, Kind::Window].into_iter().find(|kind| kind.name().eq_ignore_ascii_case(&text));
        if kind.is_none() {
            self.error(value.range(), format!("\"kind\" is \"object\", \"door\" or \"window\", not {text:?}"));
        }
        kind
    }

    fn support(&mut self, value: &Value) -> Option<Support> {
        let text = self.text(value, "support")?;
        let support = Support::from_name(&text);
        if support.is_none() {
            self.error(value.range(), format!("\"support\" is \"STANDING\", \"MOUNTED\" or \"FLOATING\", not {text:?}"));
        }
        support
    }

    fn color(&mut self, value: &Value) -> Option<String> {
        let text = self.text(value, "color")?;
        let color = color_of(&text).map(str::to_owned);
        if color.is_none() {
            let message = format!("a color is RRGGBB, not {text:?}");
            self.warnings.push(TemplateError { range: range_of(value.range()), message });
        }
        color
    }

    fn count(&mut self, value: &Value) -> Option<usize> {
        let number = value.as_number_lit().map(|number| number.value);
        let count = number.and_then(|number| number.parse::<usize>().ok()).filter(|count| (1..=MAX_OBJECTS).contains(count));
        if count.is_none() {
            let shown = number.unwrap_or(kind_of(value));
            self.error(value.range(), format!("\"count\" is a whole number from 1 to {MAX_OBJECTS}, not {shown}"));
        }
        count
    }
}

impl Template {
    /// Declares everything in an empty world, and gives the variables with what they stand for.
    pub fn declare(&self, world: &mut World) -> Result<Vec<(&str, Declared)>, SceneError> {
        world.set_title(&self.title);
        world.set_size(&mut Plain, &self.dims.map(Given::from))?;
        world.set_interior(self.interior);
        let mut variables = Vec::with_capacity(self.objects.len());
        for object in &self.objects {
            let origin = world.origins.intern(Origin { source: Source::Template, range: object.range, inside: None });
            let new = NewObject {
                kind: object.kind,
                name: &object.name,
                dims: object.dims.map(Given::from),
                support: Scalar::int(object.support as i64).into(),
                color: object.color.as_deref(),
                dynamic: object.dynamic,
            };
            let mut add = || world.add_object(&mut Plain, &new, origin);
            let declared = match object.count {
                None => Declared::One(add()?),
                Some(count) => Declared::Many((0..count).map(|_| add()).collect::<Result<_, _>>()?),
            };
            variables.push((object.id.as_str(), declared));
        }
        Ok(variables)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each mistake as the text that it stands at, and the message.
    fn mistakes(text: &str) -> Vec<(&str, String)> {
        let errors = parse(text).expect_err("mistakes");
        errors.into_iter().map(|error| (&text[error.range], error.message)).collect()
    }

    fn with_objects(objects: &str) -> String {
        format!(r#"{{"width": 5, "depth": 6.5, "height": 3, "objects": [{objects}]}}"#)
    }

    const CHAIR: &str = r##"{"id": "chairs", "name": "Chair", "width": 0.5, "depth": 0.5, "height": 0.9, "count": 2, "color": "#4169E1"}"##;
    const DOOR: &str = r#"{"id": "door", "name": "Door", "width": 1, "depth": 0.1, "height": 2, "kind": "door", "support": "STANDING"}"#;

    #[test]
    fn a_template_declares_variables_and_lists() {
        let text = with_objects(&format!("{CHAIR}, {DOOR}"));
        let template = parse(&text).expect("a good template");
        assert_eq!((template.dims[0], template.dims[1], template.interior), (Scalar::int(5), Scalar::float(6.5), true));
        let mut world = World::new();
        let variables = template.declare(&mut world).expect("room for three");
        let [chairs, door] = [Declared::Many(vec![ObjectId(0), ObjectId(1)]), Declared::One(ObjectId(2))];
        assert_eq!(variables, [("chairs", chairs), ("door", door)]);
        let layout = world.into_layout(&mut Plain);
        let place = layout.origins.get(layout.objects[1].declared);
        assert_eq!((place.source, &text[place.range]), (Source::Template, CHAIR));
        assert_eq!((layout.objects[2].body.support, layout.objects[1].color.as_deref()), (Support::Mounted, Some("4169E1")));
    }

    #[test]
    fn every_mistake_is_told_at_its_place() {
        let object = |id: &str, rest: &str| format!(r#"{{"id": {id}, "name": "A", "width": 1, "depth": 1, {rest}}}"#);
        let entries = [
            object(r#""2b""#, r#""height": 1"#),
            object(r#""class""#, r#""height": 1"#),
            object(r#""a""#, r#""height": 0"#),
            object(r#""a""#, r#""height": -1e400"#),
            object(r#""b""#, r#""height": "1""#),
            object(r#""c""#, r#""height": 1, "support": "LEANING", "kind": "gate""#),
            object(r#""d""#, r#""height": 1, "count": 2.5, "dynamic": 1"#),
            object("7", r#""height": 1, "height": 2"#),
            "[]".to_owned(),
            r#"{"id": "e"}"#.to_owned(),
        ];
        let text = with_objects(&entries.join(", "));
        let mistakes = mistakes(&text);
        let told: Vec<(&str, &str)> = mistakes.iter().map(|(at, message)| (*at, message.as_str())).collect();
        assert_eq!(
            told,
            [
                (r#""2b""#, r#""2b" is no name for a variable"#),
                (r#""class""#, r#""class" is a keyword of Python and no name for a variable"#),
                ("0", r#""height" must be positive and finite, not 0"#),
                (r#""a""#, r#"the id "a" stands twice"#),
                ("-1e400", r#""height" must be positive and finite, not -1e400"#),
                (r#""1""#, r#""height" is a number, not a string"#),
                (r#""gate""#, r#""kind" is "object", "door" or "window", not "gate""#),
                (r#""LEANING""#, r#""support" is "STANDING", "MOUNTED" or "FLOATING", not "LEANING""#),
                ("1", r#""dynamic" is true or false, not a number"#),
                ("2.5", r#""count" is a whole number from 1 to 200000, not 2.5"#),
                (r#""height""#, r#""height" stands twice"#),
                ("7", r#""id" is a string, not a number"#),
                ("[]", r#"an entry of "objects" is an object, not a list"#),
                ("{", r#""name" is missing"#),
                ("{", r#""width" is missing"#),
                ("{", r#""depth" is missing"#),
                ("{", r#""height" is missing"#),
            ]
        );
    }

    #[test]
    fn what_is_no_json_is_told_where_it_breaks() {
        assert_eq!(mistakes("{\"width\": 5,}")[0].1, "this is no JSON: trailing commas are not allowed");
        assert_eq!(mistakes("[1]")[0], ("[1]", "a template is an object, not a list".to_owned()));
        assert_eq!(mistakes("")[0].1, "the template is empty");
        assert!(mistakes(&"[".repeat(100_000))[0].1.contains("nesting depth"));
        assert!(mistakes("{\"width\": NaN}")[0].1.starts_with("this is no JSON"));
    }

    #[test]
    fn a_count_does_not_exhaust_memory() {
        let many = |count: &str| CHAIR.replace("2,", &format!("{count},"));
        assert!(mistakes(&with_objects(&many("9999999999999999999999")))[0].1.starts_with("\"count\" is a whole number"));
        let twice = format!("{}, {}", many("150000"), many("150000").replace("chairs", "stools"));
        assert_eq!(mistakes(&with_objects(&twice))[0].1, "a scene holds at most 200000 objects");
    }

    #[test]
    fn unknown_keys_and_colors_are_warnings() {
        let text = with_objects(&DOOR.replace("\"support\": \"STANDING\"", "\"colour\": 1, \"color\": \"brown\""));
        let warnings = parse(&text).expect("a good template").warnings;
        let told: Vec<_> = warnings.iter().map(|warning| &text[warning.range]).collect();
        assert_eq!(told, ["\"colour\"", "\"brown\""]);
    }

    #[test]
    fn a_byte_order_mark_moves_no_place() {
        let text = format!("\u{feff}{}", with_objects(&CHAIR.replace("0.9", "true")));
        assert_eq!(mistakes(&text)[0].0, "true");
    }

    proptest::proptest! {
        #[test]
        fn no_text_breaks_the_reader(text in "[\\[\\]{}:,\"'a-z0-9.eE+ \\\\/é🪑\u{feff}-]{0,60}") {
            for error in parse(&text).err().into_iter().flatten() {
                proptest::prop_assert!(text.get(std::ops::Range::from(error.range)).is_some());
            }
        }

        #[test]
        fn no_damage_breaks_the_reader(cut in 0..400_usize, piece in "\\PC{0,3}") {
            let text = with_objects(&format!("{CHAIR}, {DOOR}"));
            let (head, tail) = text.split_at(cut.min(text.len()));
            let text = format!("{head}{piece}{}", tail.get(1..).unwrap_or(""));
            for error in parse(&text).err().into_iter().flatten() {
                proptest::prop_assert!(text.get(std::ops::Range::from(error.range)).is_some());
            }
        }
    }
}
