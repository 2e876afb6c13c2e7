package badlog.cli.merge

import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.optionalValue
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.path
import java.nio.file.Files
import java.nio.file.Path

/** The options of all commands that put the logs of a match on one clock. */
internal class MatchOptions : OptionGroup() {
    private val offsets by option("--offset", metavar = "FILE=S").convert { Offset.of(it) ?: fail("write FILE=SECONDS") }.multiple()
        .help("Shift this log by S seconds; may be repeated.")
    private val aligned by option("--align", metavar = "enabled").choice("enabled")
        .help("Shift logs so that “enabled” matches in all.")

    /** The folder to search for the Driver Station's logs; empty for each log's own folder, null for none. */
    val station: Path? by option("--with-ds", metavar = "FOLDER").path().optionalValue(Path.of(""))
        .help("Add the Driver Station log of the same match.")

    /** Whether all given logs are read as one. */
    val isOne: Boolean get() = aligned != null || offsets.isNotEmpty()

    /**
     * Returns the way to make one log of the logs at [paths].
     *
     * @param acceptsOnly see [Merging].
     */
    fun merging(paths: List<Path>, mode: MergeMode, acceptsOnly: Boolean): Merging {
        offsets.firstOrNull { offset -> paths.none { offset.isOf(it) || Files.isDirectory(it) } }?.let {
            throw UsageError("--offset names ${it.file}, which is not among the logs to merge")
        }
        return Merging(mode, ClockChoice(offsets, aligned != null), station, acceptsOnly)
    }

    /** Returns the choice of logs at [paths] that commands read as one, according to these options. */
    fun choice(paths: List<Path>, isJson: Boolean): MatchChoice = when {
        isOne -> MatchChoice.AllInOne(merging(paths, MergeMode.BY_TOPICS, acceptsOnly = false), isJson)

        station != null -> {
            val merging = Merging(MergeMode.BY_TOPICS, ClockChoice(emptyList(), false), station, acceptsOnly = false)
            MatchChoice.EachBeside(merging, isJson)
        }

        else -> MatchChoice.AsTheyAre
    }
}
