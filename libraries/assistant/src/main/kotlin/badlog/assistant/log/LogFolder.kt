package badlog.assistant.log

import badlog.assistant.call.ToolException
import badlog.files.FolderScan
import badlog.files.LogFile
import badlog.files.partsOfLog
import badlog.files.reading
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.rules.SignalsFile
import badlog.rules.folder.FolderRules
import badlog.signals.match.NaturalOrder
import badlog.signals.vocabulary.SignalVocabulary
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The logs that an assistant may read: all logs below one folder, identified by their names in it. No name leads out of the folder, because
 * it is only compared with existing names. Links to files outside are ignored.
 *
 * @throws badlog.files.UnreadableFileException if the folder cannot be read.
 */
internal class LogFolder(folder: Path) {
    /** Its real path, with links resolved. */
    val root: Path = reading(folder) { folder.toRealPath() }

    private var known = emptyMap<String, LogFile>()

    /** Returns the current logs by name, sorted by name. */
    fun logs(): Map<String, LogFile> {
        val parents = HashMap<Path, Boolean>()
        known = reading(root) { FolderScan.of(root) }.files
            .filter { file ->
                parents.getOrPut(file.path.parent) { isInside(file.path.parent) } && partsOfLog(file.path).all(::staysInside)
            }
            .associateBy { nameOf(it.path) }
            .toSortedMap(NaturalOrder)
        return known
    }

    /**
     * Returns the log called [name], in its current state. [name] is its name in the folder, or just its file name if that is unique.
     *
     * @throws ToolException if there is none.
     */
    fun log(name: String): Pair<String, LogFile> {
        val found = find(name) ?: run {
            logs()
            find(name)
        } ?: throw ToolException("There is no log “${name.take(MAX_SHOWN)}”; list_logs lists the names of all logs.")
        val path = known.getValue(found).path
        if (!partsOfLog(path).all(::isInside)) throw ToolException("The log “$found” is no longer there; list_logs lists all logs.")
        return found to reading(path) { LogFile.of(path) }
    }

    /**
     * Returns the rules for the folder. Null if their file, or the file of signals, is a link out of the folder. Their hooks are never run.
     */
    fun rules(): FolderRules? = root.resolve(RulesFile.NAME).takeIf { file ->
        // A linked file elsewhere would be read as rules, and messages about mistakes would quote its text.
        listOf(file, root.resolve(SignalsFile.NAME)).all { !Files.exists(it) || isInside(it) }
    }?.let { FolderRules.of(it) }

    /** Returns the names of topics in the logs of the folder. */
    fun signals(): SignalVocabulary = (rules()?.rules ?: RuleSet.BUILT_IN).signals

    private fun find(name: String): String? = name.takeIf { it in known } ?: known.keys.singleOrNull { it.substringAfterLast('/') == name }

    private fun nameOf(path: Path) = root.relativize(path).joinToString("/")

    /** Returns whether [file], in a folder inside, is inside too. Only a link leads elsewhere. */
    private fun staysInside(file: Path) = !Files.isSymbolicLink(file) || isInside(file)

    private fun isInside(path: Path) = try {
        path.toRealPath().startsWith(root)
    } catch (_: IOException) {
        false
    }
}

private const val MAX_SHOWN = 200
