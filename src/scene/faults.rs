//! Everything in a scene that cannot be meant: numbers outside their range,
//! fields that contradict each other, and those that its model does not know.
//! Computes no mechanics and no distances.

mod driven;
mod equal;

use std::collections::BTreeMap;
use std::fmt::Display;

use super::limits::{
    ANGLE, BENDING_STIFFNESS, CABLE, CABLE_OFFSET, COORDINATE, CORNER_RADIUS, DISK_RADIUS,
    DISK_THICKNESS, FORCE, LEAST_MEASURED_POINTS, LENGTH, LINE_DIAMETER, LOAD, Limits, MASS,
    MEASURED_NODE, MEASURED_POINTS, NODE, OBSTACLES, OPACITY, PHOTO_WIDTH, RADIUS, READING,
    READINGS, SEGMENTS, SEGMENTS_PER_BAY, SIDE, SLIDING_SEGMENTS_PER_BAY, VERTICES, shown,
};
use super::{
    Candidates, Line, Listed, Measurements, Mechanics, Photo, Scene, SceneError, Shape, VERSION,
    polygon,
};

impl Scene {
    /// Every fault of the scene in the order of the file; empty when it is
    /// fine. Allocates nothing for a scene without faults, listed nodes and
    /// polygons aside.
    pub fn faults(&self) -> Vec<SceneError> {
        let mut faults = Faults(Vec::new());
        if self.version != VERSION {
            let found = i64::from(self.version);
            faults.0.push(SceneError::Version { found });
        }
        robot(&mut faults, self);
        driven::cables(&mut faults, self);
        driven::friction(&mut faults, &self.friction);
        driven::loads(&mut faults, self);
        if self.model.mechanics == Mechanics::Equal {
            equal::faults(&mut faults, self);
        }
        contact(&mut faults, self);
        faults.count("obstacle", self.obstacles.len(), OBSTACLES);
        for (index, obstacle) in self.obstacles.iter().enumerate() {
            let at = format_args!("obstacle[{index}]");
            shape(&mut faults, at, &obstacle.shape);
        }
        if let Some(found) = &self.measured {
            measured(&mut faults, found, self.robot.segments);
        }
        if let Some(picture) = &self.photo {
            photo(&mut faults, picture);
        }
        faults.0
    }

    /// Nothing, when the scene is fine.
    ///
    /// # Errors
    /// The first of [`Scene::faults`].
    pub fn check(&self) -> Result<(), SceneError> {
        self.faults().into_iter().next().map_or(Ok(()), Err)
    }
}

fn robot(faults: &mut Faults, scene: &Scene) {
    let (at, robot) = ("robot", &scene.robot);
    faults.number(at, "length_mm", robot.length_mm, LENGTH);

    let segments = robot.segments;
    let per_bay = robot.segments_per_bay;
    let segments_fine = faults.number(at, "segments", segments.into(), SEGMENTS);
    let key = "segments_per_bay";
    let mut per_bay_fine = faults.number(at, key, per_bay.into(), SEGMENTS_PER_BAY);
    let most = SLIDING_SEGMENTS_PER_BAY;
    if per_bay_fine && scene.model.mechanics == Mechanics::Sliding && !most.contain(per_bay.into())
    {
        let allowed = format!("{most} where the cable slides");
        faults.not_within(at, key, per_bay.into(), allowed, most);
        per_bay_fine = false;
    }
    if segments_fine && per_bay_fine && !segments.is_multiple_of(per_bay) {
        let fewer = segments - segments % per_bay;
        let more = fewer + per_bay;
        let problem = format!(
            "is {per_bay}, which does not divide robot.segments, {segments}, so that no disk sits at the tip"
        );
        let advice = if fewer == 0 {
            format!("set it to 1, or set segments to {more}")
        } else {
            format!("set it to 1, or set segments to {fewer} or {more}")
        };
        faults.conflict("robot.segments_per_bay", problem, advice);
    }

    if let Some(offset) = robot.cable_offset_mm {
        faults.number(at, "cable_offset_mm", offset, CABLE_OFFSET);
    }
    if let Some(radius) = robot.disk_radius_mm {
        let key = "disk_radius_mm";
        let radius_fine = faults.number(at, key, radius, DISK_RADIUS);
        if let Some((k, widest)) = scene.widest_cable()
            && CABLE_OFFSET.contain(widest)
            && radius_fine
            && radius < widest
        {
            let field = scene.cable_field(k, "offset_mm");
            let offset = scene.cable(k).offset_mm;
            let amount = if offset < 0.0 { "the amount of " } else { "" };
            let (least, most) = (shown(widest), shown(DISK_RADIUS.max));
            let allowed = format!("from {amount}{field}, {least}, to {most}");
            faults.not_within(at, key, radius, allowed, DISK_RADIUS);
        }
    }
    for (key, value, range) in [
        ("disk_thickness_mm", robot.disk_thickness_mm, DISK_THICKNESS),
        (
            "backbone_diameter_mm",
            robot.backbone_diameter_mm,
            LINE_DIAMETER,
        ),
        ("cable_diameter_mm", robot.cable_diameter_mm, LINE_DIAMETER),
    ] {
        faults.number(at, key, value, range);
    }
    if let Some(stiffness) = robot.bending_stiffness_nmm2 {
        let key = "bending_stiffness_nmm2";
        faults.number(at, key, stiffness, BENDING_STIFFNESS);
    }
    faults.number(at, "disk_mass_g", robot.disk_mass_g, MASS);
    faults.number(at, "backbone_mass_g", robot.backbone_mass_g, MASS);
    faults.pair("robot.base_mm", robot.base_mm, COORDINATE);
    faults.number(at, "base_angle_deg", robot.base_angle_deg, ANGLE);
}

fn contact(faults: &mut Faults, scene: &Scene) {
    let contact = &scene.contact;
    let field = "contact.listed";
    match (contact.candidates, contact.listed.is_empty()) {
        (Candidates::Listed, true) => faults.conflict(
            field,
            "names no node while contact.candidates is \"listed\"",
            "list at least one, such as [{ line = \"cable\", node = 1 }], or set candidates to \"nodes\"",
        ),
        (Candidates::Nodes | Candidates::Body, false) => faults.conflict(
            field,
            "names nodes while contact.candidates is not \"listed\"",
            "remove the list, or set candidates to \"listed\"",
        ),
        _ => {}
    }
    let mut seen = BTreeMap::new();
    for (index, entry) in contact.listed.iter().enumerate() {
        let at = format_args!("contact.listed[{index}]");
        listed(faults, at, entry, scene);
        if let Some(first) = seen.insert(*entry, index) {
            let problem = format!("is the same node as contact.listed[{first}]");
            faults.conflict(at, problem, "remove one of them");
        }
    }
}

fn listed(faults: &mut Faults, at: impl Display + Copy, entry: &Listed, scene: &Scene) {
    let robot = &scene.robot;
    let cable_fine = faults.number(at, "cable", entry.cable.into(), CABLE);
    let (node, count) = (f64::from(entry.node), scene.cable_count());
    let cable = entry.cable as usize;
    let mut last = (robot.segments, "robot.segments".to_owned());
    if entry.line != Line::Cable {
        if cable_fine && cable > 0 {
            let problem = format!("is {cable}, and the node is on no cable");
            faults.conflict(format_args!("{at}.cable"), problem, "leave it out");
        }
    } else if cable_fine && cable >= count && count > 0 {
        let allowed = format!("from 0 to the last cable, {}", count - 1);
        faults.not_within(at, "cable", cable as f64, allowed, CABLE);
    } else if cable < count
        && let Some(disk) = scene.cable(cable).to_disk
        && (1..=scene.last_disk()).contains(&disk)
    {
        let end = format!("the end of cable[{cable}]");
        last = (disk * robot.segments_per_bay, end);
    }
    let in_range = faults.number(at, "node", node, NODE);
    if !in_range || !SEGMENTS.contain(robot.segments.into()) {
        return;
    }
    if entry.node > last.0 {
        let allowed = format!("from 1 to {}, {}", last.1, last.0);
        faults.not_within(at, "node", node, allowed, NODE);
    } else if entry.line == Line::Rim && !entry.node.is_multiple_of(robot.segments_per_bay) {
        faults.conflict(
            format_args!("{at}.node"),
            format!(
                "is {node}, a node without a disk, and so without a rim, as robot.segments_per_bay is {}",
                robot.segments_per_bay
            ),
            "name a node that it divides",
        );
    }
}

fn shape(faults: &mut Faults, at: impl Display + Copy, shape: &Shape) {
    match shape {
        Shape::Disc {
            center_mm,
            radius_mm,
        } => {
            faults.pair(format_args!("{at}.center_mm"), *center_mm, COORDINATE);
            faults.number(at, "radius_mm", *radius_mm, RADIUS);
        }
        Shape::Wall {
            point_mm,
            rotation_deg,
            corner_radius_mm,
        } => {
            faults.pair(format_args!("{at}.point_mm"), *point_mm, COORDINATE);
            faults.number(at, "rotation_deg", *rotation_deg, ANGLE);
            faults.number(at, "corner_radius_mm", *corner_radius_mm, CORNER_RADIUS);
        }
        Shape::Box {
            center_mm,
            size_mm,
            rotation_deg,
            corner_radius_mm,
        } => {
            faults.pair(format_args!("{at}.center_mm"), *center_mm, COORDINATE);
            let size_fine = faults.pair(format_args!("{at}.size_mm"), *size_mm, SIDE);
            faults.number(at, "rotation_deg", *rotation_deg, ANGLE);
            let (key, radius) = ("corner_radius_mm", *corner_radius_mm);
            let radius_fine = faults.number(at, key, radius, CORNER_RADIUS);
            let most = size_mm[0].min(size_mm[1]) / 2.0;
            if size_fine && radius_fine && radius > most {
                let most = shown(most);
                let allowed = format!("from 0 to half the smaller side of {at}.size_mm, {most}");
                faults.not_within(at, key, radius, allowed, CORNER_RADIUS);
            }
        }
        Shape::Capsule {
            center_mm,
            length_mm,
            radius_mm,
            rotation_deg,
        } => {
            faults.pair(format_args!("{at}.center_mm"), *center_mm, COORDINATE);
            faults.number(at, "length_mm", *length_mm, SIDE);
            faults.number(at, "radius_mm", *radius_mm, RADIUS);
            faults.number(at, "rotation_deg", *rotation_deg, ANGLE);
        }
        Shape::Polygon {
            points_mm,
            rotation_deg,
            corner_radius_mm,
        } => {
            points(faults, format_args!("{at}.points_mm"), points_mm);
            faults.number(at, "rotation_deg", *rotation_deg, ANGLE);
            faults.number(at, "corner_radius_mm", *corner_radius_mm, CORNER_RADIUS);
        }
    }
}

fn points(faults: &mut Faults, field: impl Display + Copy, points: &[[f64; 2]]) {
    // The check of the outline takes quadratic time.
    if !faults.count(field, points.len(), VERTICES) {
        return;
    }
    let mut all_fine = true;
    for (index, point) in points.iter().enumerate() {
        all_fine &= faults.pair(format_args!("{field}[{index}]"), *point, COORDINATE);
    }
    if all_fine && let Some(problem) = polygon::fault(points) {
        let field = field.to_string();
        faults.0.push(SceneError::Polygon { field, problem });
    }
}

fn measured(faults: &mut Faults, measured: &Measurements, segments: u32) {
    backbone(faults, measured, segments);
    calibration(faults, measured);
    if faults.count("measured.force", measured.forces.len(), READINGS) {
        for (index, reading) in measured.forces.iter().enumerate() {
            let at = format_args!("measured.force[{index}]");
            faults.number(at, "load_g", reading.load_g, LOAD);
            faults.number(at, "force_g", reading.force_g, FORCE);
        }
    }
}

fn backbone(faults: &mut Faults, measured: &Measurements, segments: u32) {
    let (points, nodes) = (&measured.points_mm, &measured.nodes);
    let (field, least) = ("measured.points_mm", LEAST_MEASURED_POINTS);
    if (1..least).contains(&points.len()) {
        let (field, count) = (field.to_owned(), points.len());
        faults.0.push(SceneError::TooFew {
            field,
            count,
            least,
        });
    }
    if faults.count(field, points.len(), MEASURED_POINTS) {
        for (index, point) in points.iter().enumerate() {
            faults.pair(format_args!("{field}[{index}]"), *point, COORDINATE);
        }
    }
    let field = "measured.nodes";
    if nodes.is_empty() || !faults.count(field, nodes.len(), MEASURED_POINTS) {
        return;
    }
    if nodes.len() != points.len() {
        let (named, there) = (nodes.len(), points.len());
        faults.conflict(
            field,
            format!("has {named} entries, and measured.points_mm has {there}"),
            "name one node for each point, or remove nodes",
        );
    }
    let segments_fine = SEGMENTS.contain(segments.into());
    for (index, node) in nodes.iter().enumerate() {
        let (field, value) = (format_args!("{field}[{index}]"), f64::from(*node));
        if !MEASURED_NODE.contain(value) {
            let field = field.to_string();
            faults
                .0
                .push(SceneError::outside(field, value, &MEASURED_NODE));
        } else if segments_fine && *node > segments {
            let allowed = format!("from 0 to robot.segments, {segments}");
            let field = field.to_string();
            faults
                .0
                .push(SceneError::not_within(field, value, allowed, ""));
        } else if index > 0 && *node <= nodes[index - 1] {
            let before = nodes[index - 1];
            faults.conflict(
                field,
                format!("is {node}, which does not come after the {before} before it"),
                "order points and nodes from base to tip",
            );
        }
    }
}

/// The reading that fixes μ is one of the readings and can fix it.
fn calibration(faults: &mut Faults, measured: &Measurements) {
    let Some(index) = measured.calibration else {
        return;
    };
    let (at, key, value) = ("measured", "calibration", f64::from(index));
    if !faults.number(at, key, value, READING) {
        return;
    }
    let field = "measured.calibration";
    match measured.calibrating() {
        Some(reading) if reading.load_g > 0.0 && reading.force_g > 0.0 => {}
        Some(reading) if reading.load_g.is_nan() || reading.force_g.is_nan() => {}
        Some(reading) => {
            let (load, force) = (shown(reading.load_g), shown(reading.force_g));
            faults.conflict(
                field,
                format!("is {index}, a reading of {force} g under {load} g, which fixes no ratio"),
                "choose a reading with a positive load and force",
            );
        }
        None if measured.forces.is_empty() => faults.conflict(
            field,
            format!("is {index}, and there are no readings"),
            "add them, each under its own [[measured.force]], or remove calibration",
        ),
        None => {
            let last = measured.forces.len() - 1;
            let allowed = format!("from 0 to the last [[measured.force]], {last}");
            faults.not_within(at, key, value, allowed, READING);
        }
    }
}

fn photo(faults: &mut Faults, photo: &Photo) {
    let at = "photo";
    if photo.file.trim().is_empty() {
        faults.0.push(SceneError::Blank {
            field: "photo.file".to_owned(),
            advice: "name the picture's file, or remove [photo]".to_owned(),
        });
    }
    faults.pair("photo.center_mm", photo.center_mm, COORDINATE);
    faults.number(at, "width_mm", photo.width_mm, PHOTO_WIDTH);
    faults.number(at, "rotation_deg", photo.rotation_deg, ANGLE);
    faults.number(at, "opacity", photo.opacity, OPACITY);
}

/// The faults found so far. What tests a value says whether it was fine, and
/// spells out the field's name only when it was not.
struct Faults(Vec<SceneError>);

impl Faults {
    fn number(&mut self, at: impl Display, key: &str, value: f64, range: Limits) -> bool {
        let fine = range.contain(value);
        if !fine {
            self.0
                .push(SceneError::outside(format!("{at}.{key}"), value, &range));
        }
        fine
    }

    fn pair(&mut self, field: impl Display, pair: [f64; 2], range: Limits) -> bool {
        let mut all_fine = true;
        for (index, value) in pair.into_iter().enumerate() {
            if !range.contain(value) {
                let field = format!("{field}[{index}]");
                self.0.push(SceneError::outside(field, value, &range));
                all_fine = false;
            }
        }
        all_fine
    }

    /// Adds a number outside a range that depends on other fields.
    fn not_within(
        &mut self,
        at: impl Display,
        key: &str,
        value: f64,
        allowed: String,
        range: Limits,
    ) {
        let (field, unit) = (format!("{at}.{key}"), range.unit.symbol());
        self.0
            .push(SceneError::not_within(field, value, allowed, unit));
    }

    fn conflict(
        &mut self,
        field: impl Display,
        problem: impl Into<String>,
        advice: impl Into<String>,
    ) {
        self.0.push(SceneError::Conflict {
            field: field.to_string(),
            problem: problem.into(),
            advice: advice.into(),
        });
    }

    fn count(&mut self, field: impl Display, count: usize, limit: usize) -> bool {
        let fine = count <= limit;
        if !fine {
            let field = field.to_string();
            self.0.push(SceneError::TooMany {
                field,
                count,
                limit,
            });
        }
        fine
    }
}
