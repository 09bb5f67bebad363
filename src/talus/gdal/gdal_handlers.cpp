#ifdef TALUS_HAS_GDAL

#include "talus/gdal/gdal_handlers.hpp"

#include <vector>

namespace talus {

#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 13, 0)

// GDAL frees a handler when its place is taken, unless somebody else has a share in it, and no function gives one. So
// its private members are asked, which only an explicit instantiation may name.
namespace {

using Share = std::shared_ptr<VSIFilesystemHandler>;

std::vector<Share> all_shares();

template <auto manager, auto of_disk, auto of_prefixes>
struct AllShares {
  friend std::vector<Share> all_shares() {
    std::vector<Share> shares{(*manager()).*of_disk};
    for (const auto& [prefix, share] : (*manager()).*of_prefixes) shares.push_back(share);
    return shares;
  }
};
template struct AllShares<&VSIFileManager::Get, &VSIFileManager::m_poDefaultHandler, &VSIFileManager::m_apoHandlers>;

}  // namespace

void install_gdal_handler(const std::string& prefix, std::unique_ptr<VSIFilesystemHandler> handler) {
  static const auto* const kept = new std::vector<Share>(all_shares());  // never freed: GDAL may end after this program
  static_cast<void>(kept);
  VSIFileManager::InstallHandler(prefix, Share(std::move(handler)));
}

#else

void install_gdal_handler(const std::string& prefix, std::unique_ptr<VSIFilesystemHandler> handler) {
  // GDAL drops replaced handlers without freeing them. They are known here, so that they do not count as lost memory.
  static auto* const kept = new std::vector<VSIFilesystemHandler*>();
  kept->push_back(VSIFileManager::GetHandler(prefix.c_str()));
  VSIFileManager::InstallHandler(prefix, handler.release());
}

#endif

}  // namespace talus

#endif
