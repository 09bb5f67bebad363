"""The tables of a project file as classes. Made by settings_module.py from the declaration of the settings.

A setting that is not given (None) has its default. Numbers are in the unit that the name of the setting ends with.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
import os
from typing import Any, Literal, Mapping, Sequence, Union

import numpy as np

from .distributions import _Distribution, Empirical

__all__ = ["Table", "Analysis", "Sampling", "Terrain", "Material", "Ground", "Area", "Forest", "Shape", "Seeder", "Barrier", "Collector", "Kit", "Design", "Output", "Report", "Layer"]

Real = Union[float, "np.floating[Any]", "np.integer[Any]"]
Property = Union[Real, _Distribution, Empirical, Mapping[str, Any]]
"""A number, or a distribution that is drawn for each rock."""
File = Union[str, "os.PathLike[str]"]


class Table:
    """A table of a project file."""

    def settings(self) -> dict[str, Any]:
        """What is given, by key."""
        given = ((field.name, getattr(self, field.name)) for field in fields(self))  # type: ignore[arg-type]
        return {key: value for key, value in given if value is not None}


@dataclass(kw_only=True)
class Analysis(Table):
    """[analysis]: How rocks move.

    laws: Whose laws rocks obey: those of Talus, or those of RocFall2 and RocFall3 as their published tables need
    them. It chooses the defaults of the other keys of this table, each of which may still be given. Default:
    "talus".

    model: A rock is a point with mass and spin (`lumped_mass`, the law of CRSP), a sphere with a radius
    (`rigid_sphere`), or a block with the shape of its seeder (`rigid_body`). Results may differ by more than by any
    value of the ground: run all three. Default: "lumped_mass".

    rotation: Lumped mass: impacts couple spin and velocity; without it, they follow plain restitution. Default:
    true.

    gravity_m_s2: Acceleration of gravity. Unit: m/s2. Range: at least 1e-06, at most 1000. Default: 9.80665.

    sliding: Lumped mass: sliding is integrated in time steps, as in RocFall3 (`stepped`), or solved exactly facet
    by facet, as in RocFall2 (`closed_form`). Default: "stepped".

    max_timestep_s: Time step of stepped sliding and of rolling. Unit: s. Range: at least 0.0001, at most 1e+06.
    Default: 0.01.

    normal_velocity_cutoff_m_s: A rock that leaves an impact with a lower normal velocity than this stays on the
    ground and slides or rolls. Unit: m/s. Range: at least 0, at most 10000. Default: 0.1.

    grazing_angle_deg: A rock that slides or rolls, and meets ground at a smaller angle than this at a bend or after
    a hop over one, moves on along it without an impact, slowed by friction. With the default, results hardly depend
    on the size of cells; with 0 every bend is an impact, as in RocFall. Unit: deg. Range: at least 0, at most 45.
    Default: 15.

    stopped_velocity_m_s: A rock slower than this comes to rest where friction can hold it. Unit: m/s. Range: at
    least 0, at most 10000. Default: 0.1.

    max_steps: A trajectory with more steps than this (flights, impacts and stretches along the ground, counted
    together) ends, for the reason "maximum steps". Range: at least 1, at most 1e+09. Default: 10000.

    max_time_s: A trajectory that lasts longer than this ends, for the reason "maximum time". Unit: s. Range: more
    than 0, at most 1e+06. Default: 600.

    energy_datum_m: Elevation at which potential energy is zero. Unit: m. Range: at least -1e+09, at most 1e+09.
    Without it: the lowest point of the terrain.

    friction_angle: Lumped mass: the friction angle of sliding is the material's, follows from its tangential
    restitution as phi = arctan((1 - Rt) / Rt), or is zero. Default: "material".

    roughness_law: A rock meets the faces of rough ground by the area that they show it, in impacts and at bumps
    along the ground (`faces`); or the ground is tilted by a random angle in impacts only (`tilts`). Default:
    "faces".

    scale_rn_by_velocity: Faster impacts rebound less: Rn / (1 + (vn / K)^2), where K is `rn_velocity_scale_m_s`.
    Default: true.

    rn_velocity_scale_m_s: Normal velocity at which scaling by velocity halves the normal restitution. Unit: m/s.
    Range: more than 0, at most 10000. Default: 9.144.

    scale_rn_by_mass: Heavier rocks rebound less: Rn / (1 + (m / K)^2), where K is `rn_mass_scale_kg`. Default:
    false.

    rn_mass_scale_kg: Mass at which scaling by mass halves the normal restitution. Unit: kg. Range: more than 0, at
    most 1e+12. Default: 1000.

    tangential_crsp_damping: Rigid sphere and body: the tangential velocity of a sphere after an impact is damped as
    in CRSP. Default: true.

    rolling_resistance_in_impacts: Rigid sphere and body: rolling friction also acts on the impulse of an impact, so
    that a rock that bounces along the ground loses as much as one that rolls there. Default: true.
    """

    laws: Literal["talus", "rocfall"] | None = None
    model: Literal["lumped_mass", "rigid_sphere", "rigid_body"] | None = None
    rotation: bool | None = None
    gravity_m_s2: Real | None = None
    sliding: Literal["stepped", "closed_form"] | None = None
    max_timestep_s: Real | None = None
    normal_velocity_cutoff_m_s: Real | None = None
    grazing_angle_deg: Real | None = None
    stopped_velocity_m_s: Real | None = None
    max_steps: int | np.integer[Any] | None = None
    max_time_s: Real | None = None
    energy_datum_m: Real | None = None
    friction_angle: Literal["material", "tangential_restitution", "zero"] | None = None
    roughness_law: Literal["faces", "tilts"] | None = None
    scale_rn_by_velocity: bool | None = None
    rn_velocity_scale_m_s: Real | None = None
    scale_rn_by_mass: bool | None = None
    rn_mass_scale_kg: Real | None = None
    tangential_crsp_damping: bool | None = None
    rolling_resistance_in_impacts: bool | None = None


@dataclass(kw_only=True)
class Sampling(Table):
    """[sampling]: How random properties are drawn.

    seed: A trajectory depends only on the project, this number and the rock's number. Range: at least 0. Default:
    1.

    method: Independent draws, or draws stratified over the rocks of the campaign. Default: "monte_carlo".

    materials: Material properties are drawn at every impact, or once for each rock. Default: "per_impact".

    parameters: CSV file with a sample of uncertain parameters, such as the posterior of a calibration: a row a set,
    a column `weight`, and a column for each parameter, named by its path (`material.Scree.normal_restitution`). The
    rocks are divided into ensembles, each with a set drawn by weight. Without it: all rocks have the project's
    values.

    parameters_site: Site of the study whose columns `PATH@SITE` apply, where a posterior of several sites has a
    column of each. Without it: the only site whose columns name numbers of this project.

    ensembles: Ensembles of rocks with different parameters; rock n belongs to ensemble n modulo this number. Range:
    at least 2, at most 10000. Default: 50.
    """

    seed: int | np.integer[Any] | None = None
    method: Literal["monte_carlo", "latin_hypercube"] | None = None
    materials: Literal["per_impact", "per_rock"] | None = None
    parameters: File | None = None
    parameters_site: str | None = None
    ensembles: int | np.integer[Any] | None = None


@dataclass(kw_only=True)
class Terrain(Table):
    """[terrain]: The slope: exactly one of `section`, `mesh`, `triangles`, `raster`, a survey (`points`, `lines` or
    both), `polylines` and `polygons`. z points upwards.

    section: Two or more vertices [x, z] of a slope in section, in order along the slope; or a file that has them:
    text (.csv, .txt, ...) with the columns distance and z, or x, y and z; or one line of a DXF, GeoPackage,
    Shapefile or GeoJSON. A line in space gives the section along itself. The path is relative to the project file.
    Unit: m. Without it: one of `section`, `mesh`, `triangles`, `raster`, `points`, `lines`, `polylines` and
    `polygons` is required. Excludes mesh, vertices, triangles, raster, points, lines, polylines, polygons.

    section_layer: Layer of `section`, in a vector file or drawing. Without it: the only layer.

    section_tolerance_m: Vertices of a `section` from a file that lie within this distance of the line through the
    others are left out (Douglas-Peucker). Unit: m. Range: at least 0, at most 1e+09. Without it: all vertices are
    kept.

    section_std_dev_m: 2D: standard deviations [of x, of z], one pair for each vertex; every rock has its own slope.
    Vertices move by up to 3 standard deviations and keep their order in x. Unit: m. Without it: the vertices are
    fixed. Excludes width_m.

    width_m: Extrudes the section along y, from y = 0 to this width, into a 3D terrain. Unit: m. Range: more than 0,
    at most 1e+09. Without it: the analysis is 2D. Excludes section_std_dev_m.

    mesh: A file of triangles in metres (.obj, .stl or .ply), or a list of such files that together make the
    terrain: `["face.obj", "foot.ply"]`. Paths are relative to the project file. Without it: one of `section`,
    `mesh`, `triangles`, `raster`, `points`, `lines`, `polylines` and `polygons` is required. Excludes section,
    vertices, triangles, raster, points, lines, polylines, polygons.

    up: Axis of the mesh files that points up. With `"y"` (many modelling programs) the meshes are turned about x,
    so that their y becomes z, and their -z becomes y. Default: "z".

    vertices: Vertices [x, y, z] of an inline mesh. Unit: m. Without it: required with `triangles`. Excludes
    section, mesh, raster, points, lines, polylines, polygons.

    triangles: Triangles of an inline mesh: three vertex numbers each, starting from 0, in either winding. Without
    it: one of `section`, `mesh`, `triangles`, `raster`, `points`, `lines`, `polylines` and `polygons` is required.
    Excludes section, mesh, raster, points, lines, polylines, polygons.

    raster: A file of elevations in metres, on a grid in a projected coordinate system in metres: band 1 of a
    GeoTIFF, an Esri grid (.asc, .flt, .bil), an Erdas Imagine file or a VRT. The path is relative to the project
    file. Without it: one of `section`, `mesh`, `triangles`, `raster`, `points`, `lines`, `polylines` and `polygons`
    is required. Excludes section, mesh, vertices, triangles, points, lines, polylines, polygons.

    points: A file of surveyed points in metres, which are triangulated: text (.csv, .xyz, .txt, .pts, .dat), .las,
    or points of a GeoPackage, Shapefile, GeoJSON or DXF; alone or with `lines`. The path is relative to the project
    file. Without it: one of `section`, `mesh`, `triangles`, `raster`, `points`, `lines`, `polylines` and `polygons`
    is required. Excludes section, mesh, vertices, triangles, raster, polylines, polygons.

    point_classes: LAS: classes of the points to use; 2 is the ground. Without it: all but noise (7 and 18).

    points_layer: Layer of `points`, in a vector file. Without it: the only layer.

    lines: A vector file (GeoPackage, Shapefile, DXF, ...) of contours or breaklines with heights: their vertices
    are used as points, and no triangle crosses them; alone or with `points`. The path is relative to the project
    file. Without it: one of `section`, `mesh`, `triangles`, `raster`, `points`, `lines`, `polylines` and `polygons`
    is required. Excludes section, mesh, vertices, triangles, raster, polylines, polygons.

    lines_layer: Layer of `lines`. Without it: the only layer.

    elevation_attribute: Attribute of lines, or of points in a vector file, that gives the height of all their
    vertices in metres, as is usual for contours. Without it: the geometry's own z.

    boundary: A vector file of polygons: triangles whose centre lies outside them are left out. The path is relative
    to the project file. Without it: the convex hull of the survey.

    boundary_layer: Layer of `boundary`. Without it: the only layer.

    max_edge_m: Triangles of a survey with a longer side on the rim are removed, from the rim inwards. Unit: m.
    Range: more than 0, at most 1e+09. Without it: no limit.

    remove_spikes_m: Points of a survey further than this above or below the plane of their neighbours are removed.
    Unit: m. Range: more than 0, at most 1e+09. Without it: all points are kept.

    polylines: Closed polylines [[x, y, z], ...], each a polygon that is triangulated; the last vertex repeats the
    first. Unit: m. Without it: one of `section`, `mesh`, `triangles`, `raster`, `points`, `lines`, `polylines` and
    `polygons` is required. Excludes section, mesh, vertices, triangles, raster, points, lines, polygons.

    polygons: The same as `polylines`, from a vector file (DXF, GeoPackage, ...): closed lines or polygons with
    heights. The path is relative to the project file. Without it: one of `section`, `mesh`, `triangles`, `raster`,
    `points`, `lines`, `polylines` and `polygons` is required. Excludes section, mesh, vertices, triangles, raster,
    points, lines, polylines.

    polygons_layer: Layer of `polygons`. Without it: the only layer.

    merge_tolerance_m: Vertices of `polylines`, of `polygons` or of several meshes within this distance are merged,
    so that they make one surface; sides of polygons are also led through vertices within it. Unit: m. Range: at
    least 0, at most 1e+09. Default: 0.001.

    crs: Coordinate system of a mesh, raster or survey whose files name none, for example "EPSG:31287"; vector files
    in other systems are converted to it. "local" is for coordinates in metres without a map. Without it: that of
    the files.

    rotate_deg: 3D: rotates the terrain about the vertical, counter-clockwise seen from above; seeders and barriers
    stay in place. Unit: deg. Range: at least -360, at most 360. Default: 0.

    rotate_about: A point [x, y, z] on the vertical axis of rotation. Unit: m. Default: [0, 0, 0].
    """

    section: Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | File | None = None
    section_layer: str | None = None
    section_tolerance_m: Real | None = None
    section_std_dev_m: Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    width_m: Real | None = None
    mesh: File | Sequence[File] | np.ndarray[Any, Any] | None = None
    up: Literal["z", "y"] | None = None
    vertices: Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    triangles: Sequence[Sequence[int | np.integer[Any]] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    raster: File | None = None
    points: File | None = None
    point_classes: Sequence[int | np.integer[Any]] | np.ndarray[Any, Any] | None = None
    points_layer: str | None = None
    lines: File | None = None
    lines_layer: str | None = None
    elevation_attribute: str | None = None
    boundary: File | None = None
    boundary_layer: str | None = None
    max_edge_m: Real | None = None
    remove_spikes_m: Real | None = None
    polylines: Sequence[Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    polygons: File | None = None
    polygons_layer: str | None = None
    merge_tolerance_m: Real | None = None
    crs: str | None = None
    rotate_deg: Real | None = None
    rotate_about: Sequence[Real] | np.ndarray[Any, Any] | None = None


@dataclass(kw_only=True)
class Material(Table):
    """[[material]]: A kind of ground; one entry for each.

    name: Name that `[ground]` refers to; must be unique. Required.

    like: A material of the library (docs/materials.md, `talus materials`); its values apply where this entry gives
    none. Without it: the defaults below apply.

    normal_restitution: Rn, the part of the velocity normal to the ground that an impact returns. Range: at least 0,
    at most 1. Default: 0.35.

    tangential_restitution: Rt, the part of the velocity along the ground that remains after an impact; for a rigid
    sphere, of the velocity of its contact point, as far as friction allows (docs/laws.md). Range: at least 0, at
    most 1. Default: 0.85.

    friction_angle_deg: Lumped mass: phi, the friction angle of sliding. Unit: deg. Range: at least 0, at most 89.9.
    Default: 30.

    roughness_deg: Tilt of the small faces of the ground against the slope: a plain number is the standard deviation
    of a normal distribution about 0; 0 is smooth. Unit: deg. Range: at least 0, less than 90. Default: 0.

    roughness_spacing_m: Mean distance between the bumps that a rock meets as it slides or rolls over rough ground,
    and distance of the points to which `roughness_amplitude_m` refers; 0: no bumps. Unit: m. Range: at least 0, at
    most 100000. Default: 5.

    roughness_amplitude_m: Standard deviation of the heights of rough ground at points `roughness_spacing_m` apart,
    from which the tilts of its faces follow; in place of `roughness_deg`. With the laws of RocFall, of rigid
    spheres only, and in addition to `roughness_deg`. Unit: m. Range: at least 0, at most 100000. Default: 0.

    dynamic_friction: Rigid sphere and body: mu, the coefficient of friction while the contact slips. Range: at
    least 0, at most 1e+06. Default: 0.5.

    rolling_friction: Rigid sphere and body: mu_r, the moment that resists rolling, divided by weight and radius.
    Range: at least 0, at most 1e+06. Default: 0.1.

    forest: Density of the forest on this ground: the drag is 250 kg/s for `open`, 500 kg/s for `medium`, 750 kg/s
    for `dense`. Default: "none". Excludes forest_drag_kg_s.

    forest_drag_kg_s: b, the drag force on a rock among the trees, divided by its velocity. Unit: kg/s. Range: more
    than 0, at most 1e+12. Without it: given by `forest`. Excludes forest.

    forest_height_m: Effective height of the forest: it slows rocks whose centre is less than this above the ground.
    Unit: m. Range: more than 0, at most 10000. Without it: required with `forest` or `forest_drag_kg_s`.

    ground_drag_per_s: Viscoplastic drag of soft ground: in addition to friction, a sliding or rolling rock is
    decelerated by this times its velocity. Unit: 1/s. Range: at least 0, at most 1e+06. Default: 0.

    max_friction: Rigid body: Friction of blocks that rises with the way s that they slide: from dynamic_friction it
    comes near to this. Range: at least 0, at most 1e+06. Without it: friction does not depend on the way slid.

    friction_rise_per_m: Rigid body: kappa of that rise, 2/pi atan(kappa s). Unit: 1/m. Range: more than 0, at most
    1e+06. Without it: friction does not depend on the way slid.

    friction_decay_per_s: Rigid body: beta: in the air s fades as exp(-beta t). Unit: 1/s. Range: at least 0, at
    most 1e+06. Without it: friction does not depend on the way slid.
    """

    name: str | None = None
    like: Literal["smooth_hard_surface", "bedrock_and_boulders", "talus_and_firm_soil", "soft_soil", "clean_hard_bedrock", "asphalt", "bedrock_outcrops", "talus_cover", "talus_with_vegetation", "soft_soil_with_vegetation", "carbonate_and_igneous_rock", "schist_and_mixed_carbonate_rock", "flysch_marl_and_tuff", "weak_clastic_rock_and_evaporites", "landslide_and_glacial_deposits", "alluvium_and_colluvium", "lakes_and_glaciers"] | None = None
    normal_restitution: Property | None = None
    tangential_restitution: Property | None = None
    friction_angle_deg: Property | None = None
    roughness_deg: Property | None = None
    roughness_spacing_m: Real | None = None
    roughness_amplitude_m: Real | None = None
    dynamic_friction: Property | None = None
    rolling_friction: Property | None = None
    forest: Literal["none", "open", "medium", "dense"] | None = None
    forest_drag_kg_s: Real | None = None
    forest_height_m: Real | None = None
    ground_drag_per_s: Real | None = None
    max_friction: Real | None = None
    friction_rise_per_m: Real | None = None
    friction_decay_per_s: Real | None = None


@dataclass(kw_only=True)
class Ground(Table):
    """[ground]: The material of each part of the terrain.

    default: Name of the material where nothing else is given; required if there are several materials and none of
    `segments`, `triangles`, `raster` and `polygons`. Without it: the only material.

    segments: Section: material names, one for each segment, in the order of the vertices. Without it: the default
    everywhere. Excludes triangles, raster, polygons.

    triangles: Mesh: material numbers, one for each triangle; the materials of the file are numbered from 0. Without
    it: the default everywhere. Excludes segments, raster, polygons.

    raster: Raster and mesh: a file of classes, in any coordinate system and with cells of any size. A cell or
    triangle of the terrain has the class at its centre. The path is relative to the project file. Without it: the
    default everywhere. Excludes segments, triangles, polygons.

    classes: Material of each class of the raster, for example `{ 1 = "Rock", 2 = "Scree" }`; where there is no
    class, the default applies. Without it: required with `raster`.

    polygons: Raster and mesh: a file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system. A
    cell or triangle of the terrain takes its material from the polygon at its centre, the last one if there are
    several. The path is relative to the project file. Without it: the default everywhere. Excludes segments,
    triangles, raster.

    layer: Layer of the file of polygons. Without it: the file's only layer.

    attribute: Attribute of the polygons that gives their material. Without it: required with `polygons`.

    values: Material for each value of that attribute, for example `{ Fels = "Rock", Schutt = "Scree" }`; where
    there is no polygon, the default applies. Without it: the attribute is the name of the material.
    """

    default: str | None = None
    segments: Sequence[str] | np.ndarray[Any, Any] | None = None
    triangles: Sequence[int | np.integer[Any]] | np.ndarray[Any, Any] | None = None
    raster: File | None = None
    classes: Mapping[Any, str] | None = None
    polygons: File | None = None
    layer: str | None = None
    attribute: str | None = None
    values: Mapping[Any, str] | None = None


@dataclass(kw_only=True)
class Area(Table):
    """[[area]]: 3D: a part of the ground, drawn on plan, with another material than `[ground]` gives it; any number of
    entries. Where areas overlap, the last one applies.

    name: Name in messages; must be unique. Without it: `area N`, numbered from 1.

    material: Name of its material. Required.

    polygon: Three or more corners [x, y] on plan, in terrain coordinates. A cell or triangle of the terrain belongs
    to the area if its centre does. Unit: m. Required.
    """

    name: str | None = None
    material: str | None = None
    polygon: Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None


@dataclass(kw_only=True)
class Forest(Table):
    """[[forest]]: 3D: a forest over the ground, drawn on plan or from a file; any number of entries. The ground below
    keeps its material, whose own forest it replaces. Where forests overlap, the last one applies.

    name: Name in messages and in the names of materials in results (`Scree, in forest 1`); must be unique. Without
    it: `forest N`, numbered from 1.

    density: Density of the forest: the drag is 250 kg/s for `open`, 500 kg/s for `medium`, 750 kg/s for `dense`;
    `none` is a clearing. Without it: required without `drag_kg_s`. Excludes drag_kg_s.

    drag_kg_s: b, the drag force on a rock among the trees, divided by its velocity. Unit: kg/s. Range: more than 0,
    at most 1e+12. Without it: given by `density`. Excludes density.

    height_m: Effective height of the forest: it slows rocks whose centre is less than this above the ground. Unit:
    m. Range: more than 0, at most 10000. Without it: required, except for a clearing.

    polygon: Three or more corners [x, y] on plan, in terrain coordinates. A cell or triangle of the terrain belongs
    to the forest if its centre does. Unit: m. Without it: given by `polygons`. Excludes polygons.

    polygons: A file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system. The path is
    relative to the project file. Without it: given by `polygon`. Excludes polygon.

    layer: Layer of the file of polygons. Without it: the file's only layer.

    attribute: Attribute of the polygons that tells which of them are this forest. Without it: all polygons of the
    file are this forest.

    values: Values of that attribute, for example `["spruce", "mixed"]`. Without it: all polygons of the file are
    this forest.
    """

    name: str | None = None
    density: Literal["none", "open", "medium", "dense"] | None = None
    drag_kg_s: Real | None = None
    height_m: Real | None = None
    polygon: Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    polygons: File | None = None
    layer: str | None = None
    attribute: str | None = None
    values: Sequence[str] | np.ndarray[Any, Any] | None = None


@dataclass(kw_only=True)
class Shape(Table):
    """[[shape]]: A shape of rocks, for `shape` of a seeder; any number of entries. Rocks are convex.

    name: Name, for seeders; must be unique, and none of the words that a seeder's `shape` has. Required.

    b_over_a: Intermediate axis over the longest, drawn for each rock; in 2D, the shorter axis over the longer.
    Range: at least 0.05, at most 1. Without it: one of `of`, `scan`, `polygon`, `sides`, `axes_m`, `b_over_a` and
    `solid` is required. Excludes axes_m, solid, sides, polygon, scan, of.

    c_over_b: 3D: shortest axis over the intermediate, drawn for each rock. Range: at least 0.05, at most 1. Without
    it: required with `b_over_a` in 3D. Excludes axes_m, solid, sides, polygon, scan, of.

    axes_m: The axes of a block, three in 3D and two in 2D, in any order. Only their ratios count: the size is the
    seeder's. Unit: m. Without it: one of `of`, `scan`, `polygon`, `sides`, `axes_m`, `b_over_a` and `solid` is
    required. Excludes b_over_a, c_over_b, solid, sides, polygon, scan, of.

    style: `rounded`: the hull of points near an ellipsoid, no two blocks alike (2D: an ellipse); `angular`: of
    fewer points (3D); `box`: a box (2D: a rectangle). Default: "rounded".

    corners: 3D: number of corners of a rounded or angular block; most corners of a scan. Range: at least 6, at most
    200. Without it: 24, or 12 of an angular block; of a scan at most 48.

    power: 2D: the power p of a super-ellipse |x/a|^p + |z/b|^p = 1. Range: at least 1.5, at most 20. Without it: 2,
    an ellipse.

    solid: 3D: a regular solid, or a ball of 32 or 80 triangles. Default: "none". Excludes b_over_a, c_over_b,
    axes_m, sides, polygon, scan, of.

    sides: A regular polygon with so many sides; in 3D a prism over it. Range: at least 3, at most 48. Without it:
    one of `of`, `scan`, `polygon`, `sides`, `axes_m`, `b_over_a` and `solid` is required. Excludes b_over_a,
    c_over_b, axes_m, solid, polygon, scan, of.

    polygon: Three or more corners [x, z] of a section; in 3D a prism over it. The rock is their convex hull, scaled
    to its volume. Unit: m. Without it: one of `of`, `scan`, `polygon`, `sides`, `axes_m`, `b_over_a` and `solid` is
    required. Excludes b_over_a, c_over_b, axes_m, solid, sides, scan, of.

    length_ratio: 3D: length of the prism over the square root of the area of its section. Range: at least 0.05, at
    most 20. Without it: 1.

    scan: 3D: a file of a measured block: a mesh (OBJ, STL, PLY) or points (text), in any unit. The rock is its
    convex hull, scaled to its volume. The path is relative to the project file. Without it: one of `of`, `scan`,
    `polygon`, `sides`, `axes_m`, `b_over_a` and `solid` is required. Excludes b_over_a, c_over_b, axes_m, solid,
    sides, polygon, of.

    of: Names of other shapes, one of which is drawn for each rock. Without it: one of `of`, `scan`, `polygon`,
    `sides`, `axes_m`, `b_over_a` and `solid` is required. Excludes b_over_a, c_over_b, axes_m, solid, sides,
    polygon, scan.

    shares: Shares of the rocks, in the order of `of`; any positive numbers. Without it: equal.
    """

    name: str | None = None
    b_over_a: Property | None = None
    c_over_b: Property | None = None
    axes_m: Sequence[Real] | np.ndarray[Any, Any] | None = None
    style: Literal["rounded", "angular", "box"] | None = None
    corners: int | np.integer[Any] | None = None
    power: Real | None = None
    solid: Literal["none", "tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron", "icosphere_32", "icosphere_80"] | None = None
    sides: int | np.integer[Any] | None = None
    polygon: Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    length_ratio: Real | None = None
    scan: File | None = None
    of: Sequence[str] | np.ndarray[Any, Any] | None = None
    shares: Sequence[Real] | np.ndarray[Any, Any] | None = None


@dataclass(kw_only=True)
class Seeder(Table):
    """[[seeder]]: Where rocks start, how many, how large and how fast; any number of entries.

    name: Name in the results; must be unique. Without it: `seeder N`, numbered from 1.

    source: Source area of its rocks, for results split by source; several seeders may share one. Without it: the
    seeder's name.

    type: Rocks start at one `position`, at random along lines (`points` or `lines`), from the cells inside polygons
    (`polygons` or `polygon`) or of a raster (selected by `mask` or `min_slope_deg`), or from the rows of a `table`.
    Default: "point".

    position: [x, z] in 2D, [x, y, z] in 3D; z may be `"surface"`, or left out if `height_above_m` is given. Unit:
    m. Without it: required for a point. Excludes points.

    points: Two or more positions, each as for a point. Rocks start evenly along the line: along its length in space
    if z is given, along its length on plan if z is the surface or `height_above_m` is given. Unit: m. Without it:
    required for a line. Excludes position, lines.

    lines: 3D: a file of lines (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system. Lines without
    heights, or all lines if `height_above_m` is given, are laid on the terrain. Rocks start evenly along the length
    in space or, on the terrain, on plan. The path is relative to the project file. Without it: given by `points`.
    Excludes points.

    polygons: 3D: a file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system; rocks start
    from the cells whose centre is inside one. The path is relative to the project file. Without it: given by
    `polygon`. Excludes polygon.

    polygon: 3D: three or more corners [x, y] of one polygon on plan, in terrain coordinates. Unit: m. Without it:
    given by `polygons`. Excludes polygons.

    table: A file with a release in each row: text with columns such as `x_m`, `y_m`, `z_m`, `vx_m_s` and `mass_kg`;
    or, in 3D, points of a vector file (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system, with such
    attributes. What a row does not give follows from the other settings of the seeder. The path is relative to the
    project file. Without it: required for a table.

    name_attribute: Column of the table with the names of its rows. Without it: the column `name`, if there is one.

    layer: Layer of the file of lines, polygons or points. Without it: the file's only layer.

    source_attribute: Attribute of the lines or polygons, or column of the table, that gives the source of their
    rocks, for results split by source; where it is empty, `source` applies. Without it: `source` applies to all.

    min_slope_deg: Polygon and raster: rocks start only from cells at least this steep; the slope of a cell follows
    from its elevation and those of its eight neighbours. Unit: deg. Range: at least 0, less than 90. Without it:
    cells of any slope.

    max_slope_deg: Polygon and raster: rocks start only from cells at most this steep. Unit: deg. Range: more than
    0, at most 90. Without it: cells of any slope.

    mask: Polygon and raster: a raster of whole numbers, in any coordinate system and with cells of any size; rocks
    start only from cells with a value other than 0 at their centre. The path is relative to the project file.
    Without it: no cell is masked.

    mask_value: Value of the mask in the cells from which rocks start. Range: at least -2.14748e+09, at most
    2.14748e+09. Without it: any value but 0.

    cell_m: Size of the cells from which rocks start; their edges are at multiples of it. Unit: m. Range: at least
    0.01, at most 1e+09. Without it: required for polygon and raster seeders, unless the terrain is a raster.

    place: Where in its cell a rock starts: anywhere with equal probability, or at the centre. Default: "random".

    height_above_m: Height above the terrain, instead of z. Unit: m. Range: at least 0, at most 1e+09. Without it: 0
    for the cells of an area, else given by z.

    rocks: Total number of rocks; cells and rows get equal numbers, to within one. A table without it has one rock
    for each row. Range: at least 1, at most 1e+12. Default: 1. Excludes rocks_per_cell, rocks_per_row.

    rocks_per_cell: Polygon and raster: number of rocks from each cell. Range: at least 1, at most 1e+12. Without
    it: given by `rocks`. Excludes rocks, rocks_per_row.

    rocks_per_row: Table: number of rocks from each row. Range: at least 1, at most 1e+12. Without it: 1, or given
    by `rocks`. Excludes rocks, rocks_per_cell.

    mass_kg: Mass of a rock. Unit: kg. Range: at least 1e-09, at most 1e+12. Without it: one of `mass_kg`,
    `volume_m3` and `diameter_m` is required, unless a table gives it. Excludes volume_m3, diameter_m.

    volume_m3: Volume of a rock; its mass follows from the density. Unit: m3. Range: at least 1e-12, at most 1e+09.
    Without it: one of `mass_kg`, `volume_m3` and `diameter_m` is required, unless a table gives it. Excludes
    mass_kg, diameter_m.

    diameter_m: Diameter of the sphere with the rock's volume; its mass follows from the density. Unit: m. Range: at
    least 0.0001, at most 100000. Without it: one of `mass_kg`, `volume_m3` and `diameter_m` is required, unless a
    table gives it. Excludes mass_kg, volume_m3.

    density_kg_m3: Density of the rock; mass and density give the radius. Unit: kg/m3. Range: at least 100, at most
    20000. Default: 2700.

    shape: Rigid body: shape of the rocks: the name of a `[[shape]]`, or one of the words of docs/shapes.md, such as
    `"equant"`, `"flat"`, `"long"`, `"cube"`, `"hexagon"`. Mass and density give the volume. Default: "sphere".

    orientation_deg: Rigid body: how the rocks are turned at release. 3D: [about z, about y, about x], the last
    first; a block's longest axis is along x, its shortest along z. 2D: [angle], about y, from z to x. Unit: deg.
    Without it: random, every orientation equally likely.

    horizontal_velocity_m_s: Horizontal velocity of release, along `direction`. Unit: m/s. Range: at least -10000,
    at most 10000. Default: 0. Excludes speed_m_s.

    vertical_velocity_m_s: Vertical velocity of release, positive upwards. Unit: m/s. Range: at least -10000, at
    most 10000. Default: 0. Excludes speed_m_s.

    speed_m_s: Velocity of release along `direction` in space, not only on plan. Unit: m/s. Range: at least 0, at
    most 10000. Without it: given by `horizontal_velocity_m_s` and `vertical_velocity_m_s`. Excludes
    horizontal_velocity_m_s, vertical_velocity_m_s.

    rotational_velocity_deg_s: Spin at release, positive if the rock rolls forwards along `direction`. Unit: deg/s.
    Range: at least -1e+06, at most 1e+06. Default: 0.

    direction: [x, z] in 2D, [x, y, z] in 3D, of any length: of the horizontal velocity (then z is 0) or of
    `speed_m_s`. Or `"downslope"`: down the ground below the release, with `speed_m_s` along it; [1, 0, 0] where the
    ground is level. Without it: `"downslope"` for the cells of an area, else `[1, 0, 0]`.
    """

    name: str | None = None
    source: str | None = None
    type: Literal["point", "line", "polygon", "raster", "table"] | None = None
    position: Sequence[Real | Literal["surface"]] | np.ndarray[Any, Any] | None = None
    points: Sequence[Sequence[Real | Literal["surface"]] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    lines: File | None = None
    polygons: File | None = None
    polygon: Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    table: File | None = None
    name_attribute: str | None = None
    layer: str | None = None
    source_attribute: str | None = None
    min_slope_deg: Real | None = None
    max_slope_deg: Real | None = None
    mask: File | None = None
    mask_value: int | np.integer[Any] | None = None
    cell_m: Real | None = None
    place: Literal["random", "centre"] | None = None
    height_above_m: Real | None = None
    rocks: int | np.integer[Any] | None = None
    rocks_per_cell: int | np.integer[Any] | None = None
    rocks_per_row: int | np.integer[Any] | None = None
    mass_kg: Property | None = None
    volume_m3: Property | None = None
    diameter_m: Property | None = None
    density_kg_m3: Property | None = None
    shape: str | None = None
    orientation_deg: Sequence[Real] | np.ndarray[Any, Any] | None = None
    horizontal_velocity_m_s: Property | None = None
    vertical_velocity_m_s: Property | None = None
    speed_m_s: Property | None = None
    rotational_velocity_deg_s: Property | None = None
    direction: Sequence[Real] | np.ndarray[Any, Any] | Literal["downslope"] | None = None


@dataclass(kw_only=True)
class Barrier(Table):
    """[[barrier]]: A fence, net, wall or dam that stops rocks; any number of entries.

    name: Name in the results; must be unique among barriers and collectors. Without it: `barrier N`, numbered from
    1.

    line: Position: x in 2D; two or more points [x, y] on plan in 3D. Unit: m. Required.

    height_m: Height along its face, from the ground at its foot. Unit: m. Range: more than 0, at most 10000.
    Required.

    inclination_deg: Lean from the vertical, positive to the right of the line's direction (2D: towards +x). Unit:
    deg. Range: more than -90, less than 90. Default: 0.

    capacity_kJ: Kinetic energy that it absorbs; a rock with more breaks through and keeps the excess. Unit: kJ.
    Range: more than 0, at most 1e+20.

    normal_restitution: Rn of rocks that bounce off it; needs `tangential_restitution`. Range: at least 0, at most
    1. Without it: it holds the rocks it stops.

    tangential_restitution: Rt of rocks that bounce off it; needs `normal_restitution`. Range: at least 0, at most
    1. Without it: it holds the rocks it stops.
    """

    name: str | None = None
    line: Real | Sequence[Real] | np.ndarray[Any, Any] | Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    height_m: Real | None = None
    inclination_deg: Real | None = None
    capacity_kJ: Real | None = None
    normal_restitution: Real | None = None
    tangential_restitution: Real | None = None


@dataclass(kw_only=True)
class Collector(Table):
    """[[collector]]: A line that records passing rocks without touching them; any number of entries.

    name: Name in the results; must be unique among barriers and collectors. Without it: `collector N`, numbered
    from 1.

    line: Position: x in 2D; two or more points [x, y] on plan in 3D. Unit: m. Required.

    height_m: Height along its face, from the ground at its foot. Unit: m. Range: more than 0, at most 10000.
    Required.

    inclination_deg: Lean from the vertical, positive to the right of the line's direction (2D: towards +x). Unit:
    deg. Range: more than -90, less than 90. Default: 0.
    """

    name: str | None = None
    line: Real | Sequence[Real] | np.ndarray[Any, Any] | Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    height_m: Real | None = None
    inclination_deg: Real | None = None


@dataclass(kw_only=True)
class Kit(Table):
    """[[kit]]: A barrier kit to choose from, as its assessment describes it; any number of entries. With kits,
    `design.heights_m` and `design.energies_kJ` are not used.

    name: Name in the results; must be unique. Required.

    heights_m: Nominal heights that the assessment covers. Unit: m. Required.

    mel_kJ: Maximum energy level, of which it stops one impact. Unit: kJ. Range: more than 0, at most 1e+20.
    Required.

    sel_kJ: Service energy level, of which it stops two impacts without repair. Unit: kJ. Range: more than 0, at
    most 1e+20. Without it: a third of the MEL.

    tested_height_m: Nominal height of the kit in its test: no lower one is chosen from. Unit: m. Range: more than
    0, at most 10000. Without it: no height is refused.

    elongation_m: Maximum elongation of the net in the test at the MEL; needs `design.clearance_m` or
    `design.protect`. Unit: m. Range: at least 0, at most 10000. Without it: its elongation is not checked.

    residual_height: Category of the height that remains after an impact at the MEL: A at least half, B at least 30
    %, C less. Default: "unknown".

    cost_per_m: Price per metre of line, in any currency; of all kits or of none. Unit: 1/m. Range: more than 0, at
    most 1e+12. Without it: the cost index.
    """

    name: str | None = None
    heights_m: Sequence[Real] | np.ndarray[Any, Any] | None = None
    mel_kJ: Real | None = None
    sel_kJ: Real | None = None
    tested_height_m: Real | None = None
    elongation_m: Real | None = None
    residual_height: Literal["unknown", "A", "B", "C"] | None = None
    cost_per_m: Real | None = None


@dataclass(kw_only=True)
class Design(Table):
    """[design]: Barrier design: the demand on a barrier along lines on plan, and the kit that catches the required
    share of the rocks at the lowest cost (docs/barrier-design.md). Without this table, none of it is computed.

    lines: Names of the candidate barriers and collectors; rocks continue from a collector to the next line. Without
    it: all barriers and collectors.

    protect: Name of the collector at what is to be protected. All lines are then judged by the rocks that reach it,
    and a rock that bypasses a line is not caught. Without it: each line is judged by the rocks that reach it.

    section_m: 3D: length on plan of the sections of a line, from where it first stands on the terrain; the last
    section is half to one and a half times as long. Unit: m. Range: more than 0, at most 1e+09. Default: 10.

    free_end_m: 3D: length on plan at both ends of a line that is not relied on: rocks that cross there are not
    caught. Unit: m. Range: at least 0, at most 1e+09. Default: 0.

    clearance_m: Distance on plan from every line to what is protected, which the net must not reach. Unit: m.
    Range: at least 0, at most 1e+09. Without it: the distance on plan to the line of `protect`, section by section.

    pairs: Whether every two of the lines are also ranked together, one behind the other. Default: false.

    percentiles: Percentiles of energy, velocity and height along the lines, at most 20. Default: [50, 95, 99].

    confidence: Confidence level of the intervals of percentiles and shares. Range: more than 0, less than 1.
    Default: 0.95.

    standard: How the percentiles become requirements for a kit: the set of factors of this name; with `"none"`, no
    factors and no clearance are applied. Default: "UNI 11211-4".

    standard_file: A set of factors of one's own, in place of `standard`; the path is relative to the project file.
    Without it: `standard`.

    design_percentile: Percentile of velocity or energy, and of height, that the check is based on. Range: at least
    0, at most 100. Without it: that of the standard: 95 in UNI 11211-4; with `"none"`, 95.

    trajectory_factor: For velocities and heights, gamma_Tr: 1.02 with restitutions from back analysis, 1.10 with
    restitutions from literature. Range: at least 1, at most 1e+06. Without it: that of the standard: 1.1 in UNI
    11211-4.

    topography_factor: For velocities and heights, gamma_Dp: 1.02 with a good survey of the terrain, 1.10 with a
    poor one. Range: at least 1, at most 1e+06. Without it: that of the standard: 1.1 in UNI 11211-4.

    volume_factor: For the mass, gamma_VolF1: 1.02 with a good survey of the block, 1.10 with a poor one. Range: at
    least 1, at most 1e+06. Without it: that of the standard: 1.1 in UNI 11211-4.

    density_factor: For the mass, gamma_gamma. Range: at least 1, at most 1e+06. Without it: that of the standard: 1
    in UNI 11211-4.

    risk_factor: For the energy, gamma_R: 1.00 where little is at stake, up to 1.20 where much is. Range: at least
    1, at most 1e+06. Without it: that of the standard: 1 in UNI 11211-4.

    action_energy_factor: For the energy of the rocks, by consequence class. Range: at least 1, at most 1e+06.
    Without it: that of the standard; ONR 24810 needs it.

    action_height_factor: For the height of the rocks, by consequence class. Range: at least 1, at most 1e+06.
    Without it: that of the standard; ONR 24810 needs it.

    energy_level: Energy level that a kit must have: the maximum energy level (MEL) for one impact, or the service
    energy level (SEL), a third of it, for two. Default: "MEL".

    energy_factor: By which the kit's energy is divided, gamma_E. Range: at least 1, at most 1e+06. Without it: that
    of the standard: 1.2 for `"MEL"`, 1 for `"SEL"` in UNI 11211-4; ONR 24810 needs it.

    elongation_factor: For the elongation of a kit in its test. Range: at least 1, at most 1e+06. Without it: that
    of the standard; needed if a kit gives its elongation.

    energy: Energy that is compared with the kit's: translational, as in the standard, or total, with rotation.
    Default: "translational".

    block_mass_kg: Mass of the design block: the check then uses its energy and size, with the velocities and
    density of the rocks. Unit: kg. Range: at least 1e-09, at most 1e+12. Without it: each rock has its own mass.

    upper_clearance_m: f, the minimum clearance of a kit above the design height; in the sets of the program never
    less than half the block. Unit: m. Range: at least 0, at most 10000. Without it: that of the standard: 0.5 m in
    UNI 11211-4.

    catch_share: Share of the rocks that a kit must catch to be ranked by cost. Range: more than 0, at most 1.
    Default: 0.95.

    heights_m: Nominal heights of the available kits. Unit: m. Default: [2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9, 10].

    energies_kJ: Maximum energy levels of the available kits. Unit: kJ. Default: [100, 250, 500, 1000, 1500, 2000,
    3000, 4500].

    cost_height_exponent: a in the cost index: length x height^a x energy^b, in m and kJ. Range: at least 0, at most
    100. Default: 1.

    cost_energy_exponent: b in the cost index. Range: at least 0, at most 100. Default: 0.5.
    """

    lines: Sequence[str] | np.ndarray[Any, Any] | None = None
    protect: str | None = None
    section_m: Real | None = None
    free_end_m: Real | None = None
    clearance_m: Real | None = None
    pairs: bool | None = None
    percentiles: Sequence[Real] | np.ndarray[Any, Any] | None = None
    confidence: Real | None = None
    standard: Literal["UNI 11211-4", "ONR 24810", "none"] | None = None
    standard_file: File | None = None
    design_percentile: Real | None = None
    trajectory_factor: Real | None = None
    topography_factor: Real | None = None
    volume_factor: Real | None = None
    density_factor: Real | None = None
    risk_factor: Real | None = None
    action_energy_factor: Real | None = None
    action_height_factor: Real | None = None
    energy_level: Literal["MEL", "SEL"] | None = None
    energy_factor: Real | None = None
    elongation_factor: Real | None = None
    energy: Literal["translational", "total"] | None = None
    block_mass_kg: Real | None = None
    upper_clearance_m: Real | None = None
    catch_share: Real | None = None
    heights_m: Sequence[Real] | np.ndarray[Any, Any] | None = None
    energies_kJ: Sequence[Real] | np.ndarray[Any, Any] | None = None
    cost_height_exponent: Real | None = None
    cost_energy_exponent: Real | None = None


@dataclass(kw_only=True)
class Output(Table):
    """[output]: What is written in addition to the summary and the barrier hits.

    endpoints: Number of rocks in `endpoints.csv`: `"all"`, `"none"` or a number, evenly spread. Rocks whose paths
    are written are always included. Range: at least 0, at most 1e+12. Default: "all".

    paths: Number of rocks with a path in `paths.csv`: `"all"`, `"none"` or a number, evenly spread. Range: at least
    0, at most 1e+12. Default: 300.

    impacts: Number of rocks whose impacts are in `impacts.csv`: `"all"`, `"none"` or a number, evenly spread. With
    `"none"`, the file is not written. Range: at least 0, at most 1e+12. Default: "none".

    trajectories: Number of rocks in `trajectories.bin`, from which lines are asked after the run: `"all"`, `"none"`
    or a number, a fair sample. `"all"` if only `trajectories_MB` is given. Range: at least 0, at most 1e+12.
    Default: 10000.

    trajectories_MB: Size of `trajectories.bin`, which has fewer rocks if they do not fit: `"all"`, `"none"` or a
    number. `"all"` if only `trajectories` is given. While the run lasts, it is in memory. Unit: MB. Range: at least
    0, at most 1e+06. Default: 16.

    runout_from: Point from which runout is counted, as the distance on plan: [x] in 2D, [x, y] in 3D. Unit: m.
    Without it: from each rock's release.

    runout_along: Line on plan along which runout is counted: two or more points [x, y]. The line goes on straight
    beyond its ends; `endpoints.csv` then has the distance from it. Unit: m. Range: at least -1e+09, at most 1e+09.
    Without it: from each rock's release.

    maps: Writes where rocks pass, how fast, how high and with how much energy: in 3D as maps, GeoTIFFs in the
    folder `maps`; in 2D along the section, in `envelopes.csv`. `true` selects everything, a list only what it
    names; an empty list is `false`. Default: true.

    maps_by_source: Also writes maps of the rocks of each source, in folders of `maps/by_source`. Default: false.

    bands: With `sampling.parameters`: of these maps, also those below and above which 5 % of the ensembles are
    (`…_low`, `…_high`). `true` selects all maps but counts; each takes memory for every ensemble. Default:
    ["reach_share"].

    raster_cell_m: Size of the cells of maps and envelopes; their edges are at multiples of it. With `"terrain"`,
    the cells are those of the terrain's raster. Unit: m. Range: at least 0.01, at most 1e+09. Without it:
    `"terrain"` for a raster, otherwise 1.

    percentiles: Percentiles of energy, velocity and bounce height to map in addition to the maximum, at most 20.
    Without it: `[95]`; along a section `[50, 95, 99]`.

    means: Also maps the means of energy, velocity and bounce height. Default: false.

    geopackage: 3D: number of rocks whose end points and paths are in `results.gpkg`, together with the barriers:
    `"all"` or a number; with `"none"`, the file is not written. Range: at least 0, at most 1e+12. Default: 10000.

    vtk: Writes `paths.vtp`, the paths for ParaView, of the rocks that `paths` selects. Default: false.

    report: Writes `report.html`, a page of figures that needs no network. Default: true.
    """

    endpoints: Literal["all", "none"] | int | np.integer[Any] | None = None
    paths: Literal["all", "none"] | int | np.integer[Any] | None = None
    impacts: Literal["all", "none"] | int | np.integer[Any] | None = None
    trajectories: Literal["all", "none"] | int | np.integer[Any] | None = None
    trajectories_MB: Literal["all", "none"] | int | np.integer[Any] | None = None
    runout_from: Sequence[Real] | np.ndarray[Any, Any] | None = None
    runout_along: Real | Sequence[Real] | np.ndarray[Any, Any] | Sequence[Sequence[Real] | np.ndarray[Any, Any]] | np.ndarray[Any, Any] | None = None
    maps: bool | Sequence[Literal["passages", "reach_share", "deposits", "impacts", "energy_total", "energy_translational", "velocity", "bounce_height"]] | np.ndarray[Any, Any] | None = None
    maps_by_source: bool | None = None
    bands: bool | Sequence[Literal["passages", "reach_share", "deposits", "impacts", "energy_total", "energy_translational", "velocity", "bounce_height"]] | np.ndarray[Any, Any] | None = None
    raster_cell_m: Literal["terrain"] | Real | None = None
    percentiles: Sequence[Real] | np.ndarray[Any, Any] | None = None
    means: bool | None = None
    geopackage: Literal["all", "none"] | int | np.integer[Any] | None = None
    vtk: bool | None = None
    report: bool | None = None


@dataclass(kw_only=True)
class Report(Table):
    """[report]: The title block, the paper and the units of the report. They change no result: a run can be resumed
    after a change, and `talus report --set report.author=...` overrides them.

    client: For whom the analysis is made. Without it: left out.

    project: The work or site that the analysis belongs to; the project's `name` is the title of the sheet. Without
    it: left out.

    number: Number of the project or of the drawing. Without it: left out.

    author: Who made the analysis. Without it: left out.

    checked: Who checked it. Without it: left out.

    revision: Revision of the sheet. Without it: left out.

    date: Date, as it is to be printed. Without it: the date of the run.

    text: Any further text, such as a status or a note. Without it: left out.

    logo: A picture in the title block: a PNG or JPEG file of at most 512 kB and 4000 pixels a side. The path is
    relative to the project file. Without it: left out.

    paper: Paper of the printed report: A4 upright or A3 lengthwise. Default: "A4".

    units: Units of the report's results: metric, or US customary (ft, ft/s, lb, kip-ft). Its reader can change
    them. Inputs, coordinates on maps and all other files are metric always. Default: "metric".
    """

    client: str | None = None
    project: str | None = None
    number: str | None = None
    author: str | None = None
    checked: str | None = None
    revision: str | None = None
    date: str | None = None
    text: str | None = None
    logo: File | None = None
    paper: Literal["A4", "A3"] | None = None
    units: Literal["metric", "us"] | None = None


@dataclass(kw_only=True)
class Layer(Table):
    """[[layer]]: 3D: a raster or vector file that the workbench draws over the terrain, for reference; any number of
    entries, of which later ones are drawn over earlier ones. Layers change no result, and a run does not read them:
    it can be resumed after a change.

    name: Name in the workbench and in messages; must be unique. Without it: the file's name, without its ending.

    file: An orthophoto or another raster (GeoTIFF, PNG or JPEG with a world file, VRT, ...), or lines, polygons or
    points (GeoPackage, Shapefile, GeoJSON, DXF), in any coordinate system. The path is relative to the project
    file. Required.

    layer: Layer of a vector file with several; of a DXF the name of a CAD layer. Without it: the only one.

    name_attribute: Attribute that gives the names of the features of a vector file. Without it: `name`, if there is
    one.

    colour: Colour of the lines and points of a vector file, as `#rrggbb`. Default: "#d95f02".

    opacity: From 0, which is invisible, to 1, which hides what is below. Range: at least 0, at most 1. Default: 1.

    visible: Whether it is drawn until it is switched on or off in the workbench. Default: true.
    """

    name: str | None = None
    file: File | None = None
    layer: str | None = None
    name_attribute: str | None = None
    colour: str | None = None
    opacity: Real | None = None
    visible: bool | None = None
