# The kinds of pages of reports; each has its entry in web/src/report.
set(TALUS_REPORT_PAGES report sensitivity models calibration validation)
