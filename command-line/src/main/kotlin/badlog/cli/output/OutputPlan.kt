package badlog.cli.output

import badlog.cli.input.Failure
import badlog.cli.input.FileName
import badlog.cli.input.LogInput
import badlog.cli.input.LogSearch
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import java.nio.file.Files
import java.nio.file.Path

/**
 * Decides where results go, and never onto what is read.
 *
 * A single log that was named goes to [out] itself, unless that is a folder or ends in a slash. All others go into the folder
 * [out], in the sub-folders in which they were found. Without [out], each stands beside its log.
 *
 * @param paths what was named on the command line.
 * @param isForced whether an older file may be replaced.
 */
internal class OutputPlan(private val out: Output?, private val paths: List<Path>, private val isForced: Boolean) {
    /**
     * What `--out` names.
     *
     * @property isFolder whether it was written as a folder, with a slash at its end, which a path does not keep.
     */
    class Output(val path: Path, val isFolder: Boolean) {
        companion object {
            /** Reads what was typed. */
            fun of(text: String) = Output(Path.of(text), text.endsWith('/') || text.endsWith('\\'))
        }
    }

    private val taken = HashSet<String>()

    // Looked for before anything is written, so that no result of this run is among them.
    private val read: Set<Path> by lazy {
        LogSearch().find(paths).inputs.filter { Files.exists(it.file) }.mapTo(HashSet()) { it.file.toRealPath() }
    }

    /** The one file that [out] names, or null when it is a folder or nothing. */
    val file: Path? by lazy { out?.path?.takeUnless { out.isFolder || Files.isDirectory(it) || !isSingle() } }

    /** Whether [out] is given. */
    val isGiven: Boolean get() = out != null

    private fun isSingle() = paths.size == 1 && !Files.isDirectory(paths[0])

    /**
     * Where the result of [input] goes.
     *
     * @param besideName its name beside its log.
     * @param folderName its name in the folder for all.
     * @throws Failure when that would replace something.
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

    /** [target], which is not read, and does not exist unless it may be replaced. */
    fun checked(target: Path): Path {
        val read = read
        if (Files.isDirectory(target)) throw Failure("$target is a folder; name another file, or one inside it.")
        if (!Files.exists(target)) return target
        if (target.toRealPath() in read) {
            throw Failure("$target would overwrite a log that is read; name another file with --out.")
        }
        if (!isForced) throw Failure("$target exists already; use --force to replace it, or name another file with --out.")
        return target
    }

    /** Of two logs that would have one result, the second gets a number. */
    private fun free(wanted: Path): Path {
        val folder = wanted.toAbsolutePath().normalize().parent
        val name = FileName.of(wanted).fitting().free { taken.add(folder.resolve(it).toString().lowercase()) }
        return wanted.resolveSibling(name)
    }
}

/** The options of everything that writes one file for each log. */
internal class OutputOptions : OptionGroup() {
    private val out by option("-o", "--out", metavar = "PATH").convert { OutputPlan.Output.of(it) }
        .help("Write to this file, or for several logs to this folder.")
    private val isForced by option("--force").flag().help("Replace files that exist, but never a log that is read.")

    /** The plan for the logs below [paths]. */
    fun plan(paths: List<Path>) = OutputPlan(out, paths, isForced)

    /** What `--out` names, or null. */
    val outPath: Path? get() = out?.path
}
