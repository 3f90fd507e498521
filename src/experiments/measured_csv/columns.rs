//! What a head says: which columns a table has, and in which units.

use super::SheetFault;
use super::record::Record;
use crate::scene::quoted;
use crate::units::grams;

/// A column of numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Column {
    /// Its place, from 0.
    pub index: usize,
    /// What messages call it, such as `x_mm`.
    pub name: String,
    /// How many of the scene's units, mm or g, one of the column's is.
    pub unit: f64,
}

/// The columns of a measured backbone.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Backbone {
    pub x: Column,
    pub y: Column,
    /// The place of the nodes' column, from 0.
    pub node: Option<usize>,
}

/// The columns of force readings.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Forces {
    pub load: Column,
    pub force: Column,
}

/// The names of a unit, how many of the scene's it is, and its sign.
pub(super) type Unit = (&'static [&'static str], f64, &'static str);

/// Lengths, in mm.
pub(super) const LENGTHS: [Unit; 5] = [
    (
        &[
            "mm",
            "millimetre",
            "millimetres",
            "millimeter",
            "millimeters",
        ],
        1.0,
        "mm",
    ),
    (
        &[
            "cm",
            "centimetre",
            "centimetres",
            "centimeter",
            "centimeters",
        ],
        10.0,
        "cm",
    ),
    (&["m", "metre", "metres", "meter", "meters"], 1000.0, "m"),
    (&["um", "µm", "μm", "micron", "microns"], 1e-3, "um"),
    (&["in", "inch", "inches"], 25.4, "in"),
];

/// Weights, in g.
pub(super) fn weights() -> [Unit; 4] {
    let newton = grams(1.0);
    [
        (&["g", "gf", "gram", "grams"], 1.0, "g"),
        (&["kg", "kgf", "kilogram", "kilograms"], 1000.0, "kg"),
        (&["n", "newton", "newtons"], newton, "N"),
        (&["mn", "millinewton", "millinewtons"], 1e-3 * newton, "mN"),
    ]
}

impl Backbone {
    /// A table of two columns without a head: x and y in mm.
    pub fn without_head() -> Self {
        let column = |index, name: &str| Column {
            index,
            name: name.to_owned(),
            unit: 1.0,
        };
        Self {
            x: column(0, "x_mm"),
            y: column(1, "y_mm"),
            node: None,
        }
    }

    /// Those that a head names, as `x_mm` or as `solve` prints them; `None`
    /// where one is missing.
    ///
    /// # Errors
    /// For a unit that is not known, or one of only one of the two.
    pub fn named(head: &Record) -> Result<Option<Self>, SheetFault> {
        let find = |name: &'static str| -> Result<_, SheetFault> {
            match found(head, &[name], &LENGTHS)? {
                None => found(head, &["backbone", name], &LENGTHS),
                known => Ok(known),
            }
        };
        let (Some(x), Some(y)) = (find("x")?, find("y")?) else {
            return Ok(None);
        };
        let (x, y) = both(head, x, y)?;
        let node = head
            .fields
            .iter()
            .position(|field| words(field) == ["node"]);
        Ok(Some(Self { x, y, node }))
    }
}

impl Forces {
    /// Those that a head names, as `load_g`; `None` where one is missing.
    ///
    /// # Errors
    /// For a unit that is not known, or one of only one of the two.
    pub fn named(head: &Record) -> Result<Option<Self>, SheetFault> {
        let units = weights();
        let load = found(head, &["load"], &units)?;
        let (Some(load), Some(force)) = (load, found(head, &["force"], &units)?) else {
            return Ok(None);
        };
        let (load, force) = both(head, load, force)?;
        Ok(Some(Self { load, force }))
    }
}

/// A column as its head has it.
pub(super) struct Named {
    pub column: Column,
    /// Whether the head names its unit.
    has_unit: bool,
}

/// The first column of a name with a known unit: `x_mm`, `x (mm)`, `X [mm]`,
/// `x/mm` or `x` alone.
pub(super) fn found(
    head: &Record,
    name: &[&str],
    units: &[Unit],
) -> Result<Option<Named>, SheetFault> {
    let mut strange = None;
    for (index, field) in head.fields.iter().enumerate() {
        let words = words(field);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let Some(unit @ ([] | [_])) = words.strip_prefix(name) else {
            continue;
        };
        let known = match unit.first() {
            Some(word) => units.iter().find(|unit| unit.0.contains(word)),
            None => units.first(),
        };
        let Some((_, size, sign)) = known else {
            strange = strange.or(Some(field));
            continue;
        };
        let column = Column {
            index,
            name: format!("{}_{sign}", name.join("_")),
            unit: *size,
        };
        let has_unit = !unit.is_empty();
        return Ok(Some(Named { column, has_unit }));
    }
    match strange {
        Some(field) => {
            let signs: Vec<&str> = units.iter().map(|unit| unit.2).collect();
            Err(SheetFault::Unit {
                row: head.row,
                found: quoted(field),
                known: signs.join(", "),
            })
        }
        None => Ok(None),
    }
}

/// Two columns that either both have a unit or both have none.
fn both(head: &Record, a: Named, b: Named) -> Result<(Column, Column), SheetFault> {
    if a.has_unit == b.has_unit {
        return Ok((a.column, b.column));
    }
    let (with, without) = if a.has_unit { (a, b) } else { (b, a) };
    let field = |column: &Column| head.fields.get(column.index).map(|field| quoted(field));
    Err(SheetFault::HalfUnit {
        row: head.row,
        with: field(&with.column).unwrap_or_default(),
        without: field(&without.column).unwrap_or_default(),
    })
}

/// The words of a head's field, in small letters.
fn words(field: &str) -> Vec<String> {
    let words = field.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect()
}
