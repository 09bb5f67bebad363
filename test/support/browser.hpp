#pragma once
// A page as a browser renders it, after its scripts have run.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace talus::testing_tools {

inline bool has_browser() { return std::system("command -v chromium >/dev/null 2>&1") == 0; }

/// The text that `script` returns in the page of a file. It is run as the body of a function after the page's own
/// scripts; its text must not have line breaks.
inline std::string said_in_page(const std::filesystem::path& html, const std::string& script) {
  const std::filesystem::path asked = html.string() + ".asked.html";
  {
    std::ifstream in(html, std::ios::binary);
    std::ofstream(asked, std::ios::binary)
        << std::string{std::istreambuf_iterator<char>(in), {}}
        << "<pre id=\"said\"></pre><script>document.getElementById('said').textContent = "
           "'said:' + (() => { "
        << script << " })() + ':said';</script>";
  }
  const std::string command = "timeout 120 chromium --headless --no-sandbox --disable-gpu --user-data-dir='" +
                              asked.string() + ".profile' --dump-dom 'file://" + asked.string() + "' 2>/dev/null";
  std::string dom;
  if (std::FILE* pipe = popen(command.c_str(), "r")) {
    char buffer[4096];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) dom.append(buffer, n);
    pclose(pipe);
  }
  std::error_code ignored;
  std::filesystem::remove_all(asked.string() + ".profile", ignored);
  std::filesystem::remove(asked, ignored);
  const std::string open = "<pre id=\"said\">said:";
  const std::size_t begin = dom.find(open), end = dom.find(":said</pre>");
  if (begin == std::string::npos || end == std::string::npos) return "the page did not answer";
  return dom.substr(begin + open.size(), end - begin - open.size());
}

}  // namespace talus::testing_tools
