#pragma once
// Prints a page as a PDF file with a browser that is installed: Chromium or Chrome.

#include <filesystem>

namespace talus::cli {

/// One page to print. It is written into a folder beside the PDF file, which holds all that the browser writes, and is
/// removed with this object.
class PdfPrinting {
 public:
  /// Throws BadInput if there is no browser, or `pdf` is not a place for a file.
  explicit PdfPrinting(const std::filesystem::path& pdf);
  PdfPrinting(const PdfPrinting&) = delete;
  PdfPrinting& operator=(const PdfPrinting&) = delete;
  ~PdfPrinting();

  /// Where the caller writes the page.
  [[nodiscard]] std::filesystem::path page() const { return folder_ / "report.html"; }
  /// Prints it without a network. The PDF file appears under its name when it is complete. Returns false if a signal
  /// has asked to stop (stop_signals.hpp). Throws BadInput if the browser fails or takes longer than five minutes.
  [[nodiscard]] bool print() const;

 private:
  std::filesystem::path browser_, pdf_, folder_;
};

}  // namespace talus::cli
