package badlog.cli.output

import badlog.catalog.match.MatchMaker
import badlog.cli.input.Failure
import badlog.cli.input.FileName
import badlog.cli.input.LogInput
import badlog.cli.input.LogSearch
import badlog.cli.input.folderBeside
import badlog.files.ResultPlace
import badlog.files.UnreadableFileException
import badlog.files.partsOfLog
import badlog.files.reading
import badlog.files.requireTarget
import badlog.files.stationLogsIn
import badlog.signals.match.files.MatchManifest
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name

/**
 * Decides where results go, never overwriting an input.
 *
 * A single named log goes to [out] itself, unless that is a folder. All others go to the folder [out], in the subfolders in which they
 * were found. Without [out], each result is beside its log.
 *
 * @param paths the paths given on the command line.
 * @param isForced whether existing files may be replaced.
 * @param isOne whether all logs are read as one.
 * @param station the folder that is searched for Driver Station logs; empty for the folder of each log, null for none.
 */
internal class OutputPlan(
    private val out: ResultPlace?,
    private val paths: List<Path>,
    private val isForced: Boolean,
    private val isOne: Boolean = false,
    private val station: Path? = null,
) {
    private val taken = HashSet<String>()

    // Determined before anything is written, so that it does not include results of this run.
    private val read: Set<Path> by lazy {
        val logs = LogSearch().find(paths).inputs.map { it.file }
        val manifests = paths.mapNotNull { if (it.name == MatchManifest.NAME) it else MatchMaker.manifestIn(it) }
        val folders = station?.let { folder -> logs.mapTo(HashSet()) { folderBeside(it, folder) } }.orEmpty()
        val all = logs.flatMap(::partsOfLog) + manifests + manifests.flatMap(MatchMaker::filesOf) + folders.flatMap(::stationsIn)
        all.filter { Files.exists(it) }.mapTo(HashSet()) { it.toRealPath() }
    }

    private fun stationsIn(folder: Path): List<Path> = try {
        reading(folder) { stationLogsIn(folder) }.flatMap { partsOfLog(it.path) }
    } catch (_: UnreadableFileException) {
        // Whoever searches it says so.
        emptyList()
    }

    /** The single file that [out] names, or null if it is a folder or missing. */
    val file: Path? by lazy { out?.path?.takeUnless { out.isFolder || !isSingle() } }

    val isGiven: Boolean get() = out != null

    private fun isSingle() = isOne || (paths.size == 1 && !Files.isDirectory(paths[0]))

    /**
     * Returns the place for the result of [input].
     *
     * @param besideName its name beside its log.
     * @param folderName its name in the folder for all.
     * @throws Failure if that would replace something.
     * @throws badlog.files.UnwritableFileException if it is a folder, or an input file.
     */
    fun place(input: LogInput, besideName: String, folderName: String): Path {
        file?.let { return checked(it) }
        val wanted = if (out == null) {
            input.file.resolveSibling(besideName)
        } else {
            out.path.resolve(input.relativePath).resolveSibling(folderName)
        }
        return checked(free(wanted))
    }

    /** Returns [target] after checking that it is not an input, and does not exist unless it may be replaced. */
    fun checked(target: Path): Path {
        val read = read
        requireTarget(target, ELSEWHERE) { it.toRealPath() in read }
        if (isForced || !Files.exists(target)) return target
        throw Failure("$target exists already; use --force to replace it, or $ELSEWHERE.")
    }

    /** Returns a free path: if two logs would have the same result, the second gets a number. */
    private fun free(wanted: Path): Path {
        val folder = wanted.toAbsolutePath().normalize().parent
        val name = FileName.of(wanted).fitting().free { taken.add(folder.resolve(it).toString().lowercase()) }
        return wanted.resolveSibling(name)
    }
}

/** The options of all commands that write one file for each log. */
internal class OutputOptions : OptionGroup() {
    private val out by option("-o", "--out", metavar = "PATH").convert { ResultPlace.of(it) }
        .help("Write to this file; without an ending, to this folder.")
    private val isForced by option("--force").flag().help("Replace files that exist, but never a log that is read.")

    /** Returns the plan for the logs below [paths], which may be one. The Driver Station logs in [station] go beside them. */
    fun plan(paths: List<Path>, isOne: Boolean = false, station: Path? = null) = OutputPlan(out, paths, isForced, isOne, station)

    /** The path that `--out` names; null if there is none. */
    val outPath: Path? get() = out?.path
}

/** The advice for any `--out`: a file, a folder, or none. */
private const val ELSEWHERE = "name another place with --out"
