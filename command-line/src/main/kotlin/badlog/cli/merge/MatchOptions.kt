package badlog.cli.merge

import badlog.catalog.match.MatchMaker
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.LogSearch
import badlog.cli.input.readLog
import badlog.files.LogMaker
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

    /** The folder to search for the Driver Station's logs; empty for that of each log, null for none. */
    val station: Path? by option("--with-ds", metavar = "FOLDER").path().optionalValue(Path.of(""))
        .help("Add the Driver Station log of the same match.")

    /** Whether all logs given are one. */
    val isOne: Boolean get() = aligned != null || offsets.isNotEmpty()

    /** Returns how logs that are given by [paths] become one. */
    fun merging(paths: List<Path>, mode: MergeMode = MergeMode.BY_TOPICS): Merging {
        offsets.firstOrNull { offset -> paths.none { offset.isOf(it) || Files.isDirectory(it) } }?.let {
            throw UsageError("--offset names ${it.file}, which is not among the logs to merge")
        }
        return Merging(mode, ClockChoice(offsets, aligned != null), station, acceptsOnly = true)
    }

    /** Returns what commands read in place of the logs at [paths], where a person asked for it. */
    fun choice(paths: List<Path>): MatchChoice = when {
        isOne -> MatchChoice.AllInOne(paths, merging(paths))
        station != null -> MatchChoice.EachBeside(Merging(MergeMode.BY_TOPICS, ClockChoice(emptyList(), false), station, isSingle(paths)))
        else -> MatchChoice.AsTheyAre
    }
}

/** Whether [paths] name a single log. */
internal fun isSingle(paths: List<Path>): Boolean = paths.size == 1 && !Files.isDirectory(paths[0])

/** Which logs a command reads as one. */
internal sealed interface MatchChoice {
    /** Returns the paths to read below [paths], and what makes logs of them. */
    fun of(paths: List<Path>, console: Console): Pair<List<Path>, LogMaker>

    /** Each by itself; a ZIP or a folder of a match is one. */
    data object AsTheyAre : MatchChoice {
        override fun of(paths: List<Path>, console: Console): Pair<List<Path>, LogMaker> = paths to MatchMaker
    }

    /** All are one, which has the name of the first. */
    class AllInOne(private val paths: List<Path>, private val merging: Merging) : MatchChoice {
        override fun of(paths: List<Path>, console: Console): Pair<List<Path>, LogMaker> {
            val found = console.searching().use { LogSearch(checkpoint = it::next).find(this.paths) }
            found.failures.firstOrNull()?.let { throw it }
            val parts = found.inputs.map { input ->
                console.progress("${input.file.fileName}").use { LogPart(input.file, readLog(input.file, it)) }
            }
            val first = parts.minWithOrNull(PART_ORDER) ?: throw Failure("There is no log to read.")
            return listOf(first.file) to MergedLog(first.file, parts, merging)
        }
    }

    /** Each log of a robot has the Driver Station's of its match beside it, if that is found. */
    class EachBeside(private val merging: Merging) : MatchChoice {
        override fun of(paths: List<Path>, console: Console): Pair<List<Path>, LogMaker> = paths to LogBesideStation(merging)
    }
}
