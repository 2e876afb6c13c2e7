package badlog.cli.report

/** How findings are printed. */
internal enum class ReportForm { TEXT, CSV, JSON }
