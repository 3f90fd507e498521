//! What can be asked of a sample: a closed list, each with its unit and its meaning.

use crate::scene::nearest;

/// An output of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Output {
    /// Whether the run reached its goal.
    Status,
    /// Whether the shape's certificate holds.
    Certificate,
    /// Whether weights would hold the shape.
    StableUnderLoad,
    /// The tip's x.
    TipX,
    /// The tip's y.
    TipY,
    /// The tip's slope.
    TipSlope,
    /// How far the tip has come.
    Reach,
    /// The area that the tip has swept.
    Swept,
    /// How far the tip is from the target.
    TargetDistance,
    /// How far the backbone is from the measured one.
    ProfileRms,
    /// The least clearance.
    ClearanceMin,
    /// Contacts that press.
    Contacts,
    /// The largest contact force.
    ForceMax,
    /// All contact forces.
    ForceTotal,
    /// The largest tension.
    Tension,
    /// The first cable's pull.
    Pull,
    /// The first cable's load.
    Load,
    /// The first cable's pull at the first contact.
    FirstContactPull,
    /// The first cable's load at the first contact.
    FirstContactLoad,
    /// The largest bend.
    BendMax,
    /// The largest shear.
    ShearMax,
    /// The elastic energy.
    Energy,
    /// The share of the way that was gone.
    ReachedShare,
    /// The pull at which the branch ends.
    EndPull,
    /// Jumps on the way.
    Jumps,
}

/// An output's name, unit and meaning, and what it needs.
struct About {
    output: Output,
    name: &'static str,
    unit: &'static str,
    about: &'static str,
    needs: Needs,
}

/// What an output cannot be told without.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Needs {
    Nothing,
    /// The backbone's bending stiffness.
    Stiffness,
    /// The study's target.
    Target,
    /// The scene's measured backbone.
    Measured,
}

const fn plain(
    output: Output,
    name: &'static str,
    unit: &'static str,
    about: &'static str,
) -> About {
    About {
        output,
        name,
        unit,
        about,
        needs: Needs::Nothing,
    }
}

const fn stiff(
    output: Output,
    name: &'static str,
    unit: &'static str,
    about: &'static str,
) -> About {
    About {
        needs: Needs::Stiffness,
        ..plain(output, name, unit, about)
    }
}

const LIST: [About; 25] = [
    plain(
        Output::Status,
        "status",
        "",
        "how the run ended, a word; constraints compare it by == and !=",
    ),
    plain(
        Output::Certificate,
        "certificate",
        "",
        "1 where all conditions of an equilibrium hold, recomputed, else 0",
    ),
    plain(
        Output::StableUnderLoad,
        "stable_under_load",
        "",
        "1 where weights on the cables would hold the shape too, else 0; of sliding cables only",
    ),
    plain(
        Output::TipX,
        "tip_x_mm",
        "mm",
        "where the last node is, in the scene's frame",
    ),
    plain(
        Output::TipY,
        "tip_y_mm",
        "mm",
        "where the last node is, in the scene's frame",
    ),
    plain(
        Output::TipSlope,
        "tip_slope_deg",
        "deg",
        "how far the tip points clockwise of the base",
    ),
    plain(
        Output::Reach,
        "reach_mm",
        "mm",
        "how far the tip is from where the straight robot has it",
    ),
    plain(
        Output::Swept,
        "swept_mm2",
        "mm²",
        "area that the line from base to tip sweeps on the way from straight; costs a second run",
    ),
    About {
        needs: Needs::Target,
        ..plain(
            Output::TargetDistance,
            "target_distance_mm",
            "mm",
            "how far the tip is from target_mm",
        )
    },
    About {
        needs: Needs::Measured,
        ..plain(
            Output::ProfileRms,
            "profile_rms_mm",
            "mm",
            "root of the mean squared distance from the scene's measured backbone",
        )
    },
    plain(
        Output::ClearanceMin,
        "clearance_min_mm",
        "mm",
        "least clearance of what may touch from any obstacle, 0 in contact",
    ),
    plain(Output::Contacts, "contacts", "", "contacts that press"),
    stiff(
        Output::ForceMax,
        "force_max_n",
        "N",
        "largest force of an obstacle on the robot, 0 without contact",
    ),
    stiff(
        Output::ForceTotal,
        "force_total_n",
        "N",
        "sum of the amounts of all contact forces",
    ),
    stiff(
        Output::Tension,
        "tension_n",
        "N",
        "largest tension of a cable",
    ),
    plain(
        Output::Pull,
        "pull_mm",
        "mm",
        "of the first cable, given or found",
    ),
    stiff(
        Output::Load,
        "load_g",
        "g",
        "weight that hangs on the first cable or would hold it",
    ),
    plain(
        Output::FirstContactPull,
        "first_contact_pull_mm",
        "mm",
        "of the first cable where the robot first touches; empty where it never does",
    ),
    stiff(
        Output::FirstContactLoad,
        "first_contact_load_g",
        "g",
        "on the first cable where the robot first touches; empty where it never does",
    ),
    plain(
        Output::BendMax,
        "bend_max_deg",
        "deg",
        "largest bend of a segment, by its amount",
    ),
    plain(
        Output::ShearMax,
        "shear_max_deg",
        "deg",
        "largest shear of a segment, by its amount",
    ),
    stiff(
        Output::Energy,
        "energy_nmm",
        "N mm",
        "elastic energy of the backbone",
    ),
    plain(
        Output::ReachedShare,
        "reached_share",
        "",
        "share of the way from straight that was gone, 1 at the goal",
    ),
    plain(
        Output::EndPull,
        "end_pull_mm",
        "mm",
        "of the first cable where the branch ends; empty where it leads to the goal",
    ),
    plain(Output::Jumps, "jumps", "", "jumps on the way"),
];

impl Output {
    /// Every output, in the order of the list.
    pub fn all() -> impl Iterator<Item = Output> {
        LIST.iter().map(|about| about.output)
    }

    /// The output of a name.
    ///
    /// # Errors
    /// The known name that is spelled most like it, if one is near.
    pub fn of_name(name: &str) -> Result<Self, Option<&'static str>> {
        let found = LIST.iter().find(|about| about.name == name);
        let names: Vec<_> = LIST.iter().map(|about| about.name).collect();
        found
            .map(|about| about.output)
            .ok_or_else(|| nearest(name, &names))
    }

    fn about(self) -> &'static About {
        &LIST[self as usize]
    }

    /// Its name, which tells its unit.
    pub fn name(self) -> &'static str {
        self.about().name
    }

    /// The sign of its unit, empty for plain counts.
    pub fn unit(self) -> &'static str {
        self.about().unit
    }

    /// What it means: a phrase without a full stop.
    pub fn meaning(self) -> &'static str {
        self.about().about
    }

    pub(super) fn needs(self) -> Needs {
        self.about().needs
    }

    /// Whether it tells of the way and not of the shape, and so stands in a row whose
    /// goal was not reached, too.
    pub(super) fn is_of_the_way(self) -> bool {
        matches!(
            self,
            Output::Status
                | Output::FirstContactPull
                | Output::FirstContactLoad
                | Output::ReachedShare
                | Output::EndPull
                | Output::Jumps
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_is_in_the_order_of_the_outputs() {
        for (index, about) in LIST.iter().enumerate() {
            assert_eq!(about.output as usize, index, "{}", about.name);
            assert_eq!(Output::of_name(about.name), Ok(about.output));
        }
    }

    #[test]
    fn names_tell_the_unit() {
        for output in Output::all() {
            let suffix = match output.unit() {
                "" => continue,
                "mm" => "_mm",
                "mm²" => "_mm2",
                "N" => "_n",
                "N mm" => "_nmm",
                "g" => "_g",
                "deg" => "_deg",
                other => panic!("{other}"),
            };
            assert!(output.name().ends_with(suffix), "{}", output.name());
        }
    }

    #[test]
    fn a_slip_finds_the_name_that_was_meant() {
        assert_eq!(Output::of_name("force_max"), Err(Some("force_max_n")));
        assert_eq!(Output::of_name("qqq"), Err(None));
    }
}
