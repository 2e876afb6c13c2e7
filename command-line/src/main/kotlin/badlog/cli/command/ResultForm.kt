package badlog.cli.command

import com.github.ajalt.clikt.core.UsageError

/** The form of a printed list of results. */
internal enum class ResultForm {
    TEXT,
    CSV,
    JSON,
    ;

    companion object {
        /** Returns the form requested by `--csv` and `--json`. */
        fun of(isCsv: Boolean, isJson: Boolean): ResultForm = when {
            isCsv && isJson -> throw UsageError("--csv and --json cannot be used together")
            isCsv -> CSV
            isJson -> JSON
            else -> TEXT
        }
    }
}
