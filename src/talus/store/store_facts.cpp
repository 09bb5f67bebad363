#include "talus/store/store_facts.hpp"

#include "talus/campaign/simulate.hpp"
#include "talus/store/path_bytes.hpp"

namespace talus {

namespace {

/// What rocks are.
enum StoredRocks : std::uint8_t { of_points, of_spheres, with_blocks };

void save_names(ByteWriter& out, const std::vector<std::string>& names) {
  out.count(names.size());
  for (const std::string& name : names) out.text(name);
}
std::vector<std::string> read_names(ByteReader& in) {
  std::vector<std::string> names(in.count(sizeof(std::uint64_t)));
  for (std::string& name : names) name = in.text();
  return names;
}

}  // namespace

StoreFacts StoreFacts::of(const Model& model) {
  StoreFacts facts;
  facts.is_section = std::holds_alternative<Profile>(*model.surface);
  facts.is_sphere = has_extent(model.laws.model);
  facts.has_blocks = talus::has_blocks(model);
  facts.origin = model.frame.origin + Vec3{};  // without negative zeros
  facts.gravity = model.laws.gravity;
  facts.energy_datum = model.energy_datum;
  facts.seed = model.seed;
  facts.planned = model.rocks();
  facts.ensembles = model.ensembles.size();
  for (const Seeder& seeder : model.seeders) facts.seeders.push_back(seeder.name);
  facts.sources = model.sources;
  for (const Material& material : model.ground.materials()) facts.materials.push_back(material.name);
  const Box bounds = std::visit([](const auto& surface) { return surface.bounds(); }, *model.surface);
  facts.grid = StoreGrid::over({bounds.low.xy(), bounds.high.xy()}, facts.is_section);
  return facts;
}

void StoreFacts::save(ByteWriter& out) const {
  out.flag(is_section);
  out.put(static_cast<std::uint8_t>(has_blocks ? with_blocks : is_sphere ? of_spheres : of_points));
  for (const double x : coordinates(origin)) out.put(x);
  for (const double x : coordinates(gravity)) out.put(x);
  out.put(energy_datum);
  out.put(seed);
  out.put(planned);
  out.put(ensembles);
  save_names(out, seeders);
  save_names(out, sources);
  save_names(out, materials);
  grid.save(out);
}

StoreFacts StoreFacts::read(ByteReader& in) {
  StoreFacts facts;
  facts.is_section = in.flag();
  const auto rocks = in.get<std::uint8_t>();
  expect_bytes(rocks <= with_blocks, "its rocks are of no known kind");
  facts.is_sphere = rocks != of_points;
  facts.has_blocks = rocks == with_blocks;
  facts.origin = get_vector<double>(in, false);
  facts.gravity = get_vector<double>(in, false);
  facts.energy_datum = get_number<double>(in);
  facts.seed = in.get<std::uint64_t>();
  facts.planned = in.get<std::uint64_t>();
  facts.ensembles = in.get<std::uint64_t>();
  facts.seeders = read_names(in);
  facts.sources = read_names(in);
  facts.materials = read_names(in);
  facts.grid = StoreGrid::read(in);
  return facts;
}

}  // namespace talus
