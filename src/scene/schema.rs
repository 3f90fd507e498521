//! The JSON Schema of scene files, for editors that check and complete TOML.
//!
//! Made from the same table of keys and the same ranges as the checks. What a
//! schema cannot say (a polygon's convexity, fields that depend on each other)
//! is left to [`super::Scene::faults`].

use serde_json::{Map, Value, json};

use super::keys::{Key, Kind, Presence, SCENE, SHAPES, ShapeKeys};
use super::limits::{self, Limits, Unit};
use super::{Friction, Loads, Model, Scene, VERSION};

/// The schema as indented JSON, draft 2020-12.
pub fn json() -> String {
    format!("{:#}", value())
}

/// The schema as a JSON value.
pub fn value() -> Value {
    let mut schema = object(SCENE, &defaults());
    schema["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    schema["title"] = json!("Sinew scene");
    schema["description"] =
        json!("A cable-driven continuum robot, its actuation and the obstacles around it.");
    // One cable with the robot, or each on its own.
    schema["oneOf"] = json!([
        {
            "required": ["actuation"],
            "properties": {
                "robot": { "required": ["cable_offset_mm"] },
                "cable": { "maxItems": 0 },
            },
        },
        {
            "required": ["cable"],
            "properties": {
                "robot": { "not": { "required": ["cable_offset_mm"] } },
                "cable": { "minItems": 1 },
            },
            "not": { "required": ["actuation"] },
        },
    ]);
    // The nodes are listed when, and only when, the list is asked for.
    let contact = &mut schema["properties"]["contact"];
    contact["if"] = json!({ "properties": { "candidates": { "const": "listed" } }, "required": ["candidates"] });
    contact["then"] =
        json!({ "required": ["listed"], "properties": { "listed": { "minItems": 1 } } });
    contact["else"] = json!({ "properties": { "listed": { "maxItems": 0 } } });
    schema
}

/// What stands for a key that is left out, in the shape of the file.
fn defaults() -> Value {
    let mut defaults = json!(Scene::default());
    // No cable stands for one that is left out.
    defaults["robot"]["cable_offset_mm"] = Value::Null;
    defaults["model"] = json!(Model::default());
    defaults["friction"] = json!(Friction::default());
    defaults["loads"] = json!(Loads::default());
    // What is not written where it is 0.
    for key in ["cable_diameter_mm", "disk_mass_g", "backbone_mass_g"] {
        defaults["robot"][key] = json!(0.0);
    }
    defaults["cable"] = json!({ "diameter_mm": 0.0 });
    defaults["contact"]["listed"] = json!({ "cable": 0 });
    // What every shape of obstacle and a photograph fall back to; see the
    // attributes of `Shape` and `Photo`.
    defaults["obstacle"] = json!({ "rotation_deg": 0.0, "corner_radius_mm": 0.0 });
    defaults["photo"] = json!({ "rotation_deg": 0.0, "opacity": 1.0 });
    defaults
}

fn object(keys: &[Key], defaults: &Value) -> Value {
    let mut properties = Map::new();
    for key in keys {
        let default = &defaults[key.name];
        let mut property = of_kind(&key.kind, default);
        property["description"] = json!(sentence(key.about, &key.kind));
        let is_plain = !default.is_null() && !default.is_object();
        if key.presence == Presence::Optional && is_plain {
            property["default"] = default.clone();
        }
        properties.insert(key.name.to_owned(), property);
    }
    let required: Vec<_> = keys
        .iter()
        .filter(|key| key.presence == Presence::Required)
        .map(|key| key.name)
        .collect();
    let mut object = json!({
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    });
    let choice: Vec<_> = keys
        .iter()
        .filter(|key| key.presence == Presence::OneOf)
        .map(|key| json!({ "required": [key.name] }))
        .collect();
    if !choice.is_empty() {
        object["oneOf"] = json!(choice);
    }
    object
}

fn of_kind(kind: &Kind, defaults: &Value) -> Value {
    match kind {
        Kind::Version => json!({ "const": VERSION }),
        Kind::Number(range) => ranged("number", range),
        Kind::Whole(range) => ranged("integer", range),
        Kind::Text => json!({ "type": "string" }),
        Kind::Word(words) => json!({ "enum": words }),
        Kind::Pair(range) => {
            json!({ "type": "array", "items": ranged("number", range), "minItems": 2, "maxItems": 2 })
        }
        Kind::Points(range, least, most) => json!({
            "type": "array",
            "items": of_kind(&Kind::Pair(*range), &Value::Null),
            "minItems": least,
            "maxItems": most,
        }),
        Kind::Wholes(range, most) => {
            json!({ "type": "array", "items": ranged("integer", range), "maxItems": most })
        }
        Kind::Table(keys) => object(keys, defaults),
        Kind::Tables(keys, most, _) => {
            json!({ "type": "array", "items": object(keys, defaults), "maxItems": most })
        }
        Kind::Obstacles => json!({
            "type": "array",
            "maxItems": limits::OBSTACLES,
            "items": { "oneOf": SHAPES.iter().map(|shape| of_shape(shape, defaults)).collect::<Vec<_>>() },
        }),
    }
}

fn of_shape(shape: &ShapeKeys, defaults: &Value) -> Value {
    let mut schema = object(shape.keys, defaults);
    schema["title"] = json!(shape.word);
    schema["description"] = json!(capitalised(shape.about) + ".");
    schema["properties"]["shape"] =
        json!({ "const": shape.word, "description": "The shape of the obstacle." });
    schema
}

fn ranged(kind: &str, range: &Limits) -> Value {
    let bound = |value: f64| {
        if value.fract() == 0.0 {
            json!(value as i64)
        } else {
            json!(value)
        }
    };
    json!({ "type": kind, "minimum": bound(range.min), "maximum": bound(range.max) })
}

fn sentence(about: &str, kind: &Kind) -> String {
    let unit = match kind {
        Kind::Number(range) | Kind::Pair(range) | Kind::Points(range, ..) => range.unit,
        _ => Unit::One,
    };
    let unit = match unit {
        Unit::Millimetre => ", in millimetres",
        Unit::Degree => ", in degrees",
        Unit::Gram => ", in grams",
        Unit::NewtonSquareMillimetre => ", in N mm²",
        Unit::Newton => ", in newtons",
        Unit::NewtonMillimetre => ", in N mm",
        Unit::MetrePerSecondSquared => ", in m/s²",
        Unit::One => "",
    };
    format!("{}{unit}.", capitalised(about))
}

fn capitalised(phrase: &str) -> String {
    let mut letters = phrase.chars();
    letters
        .next()
        .map(|first| first.to_uppercase().to_string() + letters.as_str())
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::*;

    const FULL: &str = include_str!("../../tests/cases/scene/full.toml");
    const CABLES: &str = include_str!("../../tests/cases/scene/cables.toml");

    /// Whether the instance satisfies the schema, for the keywords used here;
    /// any other keyword fails the test.
    fn satisfies(schema: &Value, instance: &Value) -> bool {
        let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
        let bound = |rule: &Value| rule.as_f64().unwrap();
        let length = |value: &Value| list(value).len() as u64;
        schema
            .as_object()
            .unwrap()
            .iter()
            .all(|(keyword, rule)| match keyword.as_str() {
                "$schema" | "title" | "description" | "default" | "then" | "else" => true,
                "type" => match rule.as_str().unwrap() {
                    "object" => instance.is_object(),
                    "array" => instance.is_array(),
                    "string" => instance.is_string(),
                    "number" => instance.is_number(),
                    "integer" => instance.is_i64(),
                    other => panic!("unknown type {other}"),
                },
                "const" => instance == rule,
                "enum" => list(rule).contains(instance),
                "minimum" => instance.as_f64().is_none_or(|number| number >= bound(rule)),
                "maximum" => instance.as_f64().is_none_or(|number| number <= bound(rule)),
                "minItems" => length(instance) >= rule.as_u64().unwrap(),
                "maxItems" => length(instance) <= rule.as_u64().unwrap(),
                "items" => list(instance).iter().all(|item| satisfies(rule, item)),
                "required" => list(rule)
                    .iter()
                    .all(|key| instance.get(key.as_str().unwrap()).is_some()),
                "properties" => rule.as_object().unwrap().iter().all(|(key, rule)| {
                    instance.get(key).is_none_or(|value| satisfies(rule, value))
                }),
                "additionalProperties" => instance
                    .as_object()
                    .unwrap()
                    .keys()
                    .all(|key| *rule == json!(true) || schema["properties"].get(key).is_some()),
                "oneOf" => {
                    list(rule)
                        .iter()
                        .filter(|rule| satisfies(rule, instance))
                        .count()
                        == 1
                }
                "if" => satisfies(
                    &schema[if satisfies(rule, instance) {
                        "then"
                    } else {
                        "else"
                    }],
                    instance,
                ),
                "not" => !satisfies(rule, instance),
                other => panic!("unknown keyword {other}"),
            })
    }

    #[track_caller]
    fn check(text: &str, expected: bool) {
        let instance: Value = toml::from_str(text).unwrap();
        assert_eq!(satisfies(&value(), &instance), expected, "{text}");
    }

    #[test]
    fn every_asset_and_the_full_scene_satisfy_the_schema() {
        check(FULL, true);
        check(CABLES, true);
        check(&Scene::default().to_toml().unwrap(), true);
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/scenes");
        for entry in std::fs::read_dir(folder).unwrap() {
            let text = std::fs::read_to_string(entry.unwrap().path()).unwrap();
            check(&text, true);
            check(&Scene::from_toml(&text).unwrap().to_toml().unwrap(), true);
        }
    }

    #[test]
    fn slips_do_not_satisfy_the_schema() {
        for (old, new) in [
            ("version = 2", "version = 1"),
            ("\"sliding\"", "\"gliding\""),
            ("cable_offset_mm = 8.0\n", ""),
            ("holes = 0.275", "holes = -0.275"),
            ("base_loss = 0.165", "base_loss = 1"),
            ("[0.375, -9.80665]", "-9.80665"),
            ("title", "titel"),
            ("base_mm", "basis_mm"),
            ("size_mm", "radius_mm = 1\nsize_mm"),
            ("180.0", "\"long\""),
            ("180.0", "0.5"),
            ("= 18\n", "= 18.5\n"),
            ("[1.0, 2.0]", "[1.0]"),
            ("\"listed\"", "\"nodes\""),
            (
                "[{ line = \"cable\", node = 14 }, { line = \"backbone\", node = 18 }]",
                "[]",
            ),
            ("shape = \"disc\"", "shape = \"wall\""),
            ("radius_mm = 15.0", "radius_mm = 0"),
            ("[75.0, 150.0], ", ""),
            ("pull_mm = 5.0", ""),
            ("pull_mm = 5.0", "pull_mm = 5.0\nload_g = 1"),
            (
                "pull_mm = 5.0",
                "pull_mm = 5.0\n[[cable]]\noffset_mm = 8\npull_mm = 1",
            ),
            ("8700.0", "0"),
            ("[0, 9, 17]", "[0, 9.5, 17]"),
            ("[[1.0, 2.0], [6.5, 92.0], [30.0, 175.0]]", "[[1.0, 2.0]]"),
            ("load_g = 50.0", "load_g = -50.0"),
            ("opacity = 0.75", "opacity = 1.25"),
            ("file = \"photo.jpg\"", ""),
        ] {
            assert!(FULL.contains(old), "{old}");
            check(&FULL.replacen(old, new, 1), false);
        }
        for (old, new) in [
            ("load_g = 300.0", ""),
            ("load_g = 300.0", "load_g = 300.0\npull_mm = 1"),
            ("segments = 18", "segments = 18\ncable_offset_mm = 8"),
            ("[contact]", "[actuation]\npull_mm = 1\n[contact]"),
            ("to_disk = 7", "to_disk = 0"),
            ("20000.0", "0"),
            ("\"rim\"", "\"edge\""),
            ("cable = 1, ", "cable = -1, "),
        ] {
            assert!(CABLES.contains(old), "{old}");
            check(&CABLES.replacen(old, new, 1), false);
        }
    }

    /// The paths of all properties, `obstacle.box.size_mm` say.
    fn schema_keys(schema: &Value, at: &str, keys: &mut BTreeSet<String>) {
        for (key, property) in schema["properties"].as_object().into_iter().flatten() {
            keys.insert(format!("{at}{key}"));
            assert!(
                property["description"].as_str().unwrap().ends_with('.'),
                "{at}{key}"
            );
            schema_keys(property, &format!("{at}{key}."), keys);
            schema_keys(&property["items"], &format!("{at}{key}."), keys);
            // A choice of tables has titles, one of keys has none.
            for shape in property["items"]["oneOf"].as_array().into_iter().flatten() {
                if let Some(title) = shape["title"].as_str() {
                    schema_keys(shape, &format!("{at}{key}.{title}."), keys);
                }
            }
        }
    }

    fn scene_keys(table: &Value, at: &str, keys: &mut BTreeSet<String>) {
        for (key, value) in table.as_object().unwrap() {
            keys.insert(format!("{at}{key}"));
            let items = value
                .as_array()
                .into_iter()
                .flatten()
                .chain([value])
                .filter(|item| item.is_object());
            for item in items {
                let shape = item
                    .get("shape")
                    .map(|word| format!("{}.", word.as_str().unwrap()));
                scene_keys(
                    item,
                    &format!("{at}{key}.{}", shape.unwrap_or_default()),
                    keys,
                );
            }
        }
    }

    #[test]
    fn the_table_of_keys_and_the_types_have_the_same_keys() {
        let (mut known, mut written) = (BTreeSet::new(), BTreeSet::new());
        schema_keys(&value(), "", &mut known);
        let by_load = FULL.replace("pull_mm = 5.0", "load_g = 300.0");
        for text in [FULL, &by_load, CABLES] {
            scene_keys(&json!(Scene::from_toml(text).unwrap()), "", &mut written);
        }
        assert_eq!(known, written);
    }

    #[test]
    fn defaults_in_the_schema_are_those_of_the_types() {
        let least = "version = 2
            model = { mechanics = \"equal\" }
            robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
            actuation = { pull_mm = 0 }";
        assert_eq!(Scene::from_toml(least), Ok(Scene::default()));
        let robot = &value()["properties"]["robot"]["properties"];
        assert_eq!(robot["segments_per_bay"]["default"], json!(2));
        for key in ["length_mm", "cable_offset_mm"] {
            assert_eq!(robot[key].get("default"), None);
        }
        let sliding = least.replace("model", "# model");
        let scene = json!(Scene::from_toml(&sliding).unwrap());
        let properties = &value()["properties"];
        let mechanics = &properties["model"]["properties"]["mechanics"];
        assert_eq!(scene["model"]["mechanics"], mechanics["default"]);
        for key in ["cable_diameter_mm", "disk_mass_g"] {
            assert_eq!(robot[key]["default"], json!(0.0));
        }
        let gravity = &properties["loads"]["properties"]["gravity_m_s2"];
        assert_eq!(gravity["default"], json!([0.0, 0.0]));
        let cable = &properties["cable"]["items"]["properties"];
        assert_eq!(cable["diameter_mm"]["default"], json!(0.0));
        assert_eq!(cable["load_g"].get("default"), None);
        let photo = "[photo]\nfile = \"a.png\"\ncenter_mm = [0, 0]\nwidth_mm = 1";
        let scene = json!(Scene::from_toml(&format!("{least}\n{photo}")).unwrap());
        let properties = &value()["properties"]["photo"]["properties"];
        for key in ["rotation_deg", "opacity"] {
            assert_eq!(scene["photo"][key], properties[key]["default"]);
        }
        let wall = "[[obstacle]]\nshape = \"wall\"\npoint_mm = [50, 0]";
        let scene = json!(Scene::from_toml(&format!("{least}\n{wall}")).unwrap());
        assert_eq!(
            scene["obstacle"][0]["rotation_deg"],
            defaults()["obstacle"]["rotation_deg"]
        );
        assert_eq!(
            scene["obstacle"][0]["corner_radius_mm"],
            defaults()["obstacle"]["corner_radius_mm"]
        );
    }
}
