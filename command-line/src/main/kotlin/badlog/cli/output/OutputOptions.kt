package badlog.cli.output

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import java.nio.file.Path

/** The options of everything that writes one file for each log. */
internal class OutputOptions : OptionGroup() {
    private val out by option("-o", "--out", metavar = "PATH").convert { OutputPlan.Output.of(it) }
        .help("Write to this file, or for several logs into this folder.")
    private val isForced by option("--force").flag().help("Replace files that exist, but never a log that is read.")

    /** The plan for the logs below [paths]. */
    fun plan(paths: List<Path>) = OutputPlan(out, paths, isForced)

    /** What `--out` names, or null. */
    val outPath: Path? get() = out?.path
}
