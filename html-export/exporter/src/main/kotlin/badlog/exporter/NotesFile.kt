package badlog.exporter

import badlog.files.UnreadableFileException
import badlog.files.appendLines
import badlog.files.appendedText
import badlog.files.computerName
import badlog.files.reading
import badlog.viewer.choices.changeTime
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NoteChange
import badlog.viewer.choices.note.NoteHistory
import badlog.viewer.choices.note.NotesException
import badlog.viewer.choices.note.noteChangesOf
import badlog.viewer.choices.note.notesOfJson
import badlog.viewer.choices.note.toLine
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path
import java.util.UUID

/**
 * The files beside a log that contain its notes. Each computer appends lines to its own file, such as `q42.bag.notes-pit-3f2a.jsonl` for
 * `q42.bag`, and all files are read, so that a synced folder or git has no conflicts to resolve. Older versions wrote `q42.bag.notes.json`;
 * its notes come first.
 */
object NotesFile {
    /** The maximum size of a file with notes. */
    private const val MAX_BYTES = 16L shl 20

    /** Returns the path of the notes that older versions wrote for [log]; the file need not exist. */
    fun beginningOf(log: Path): Path = log.resolveSibling("${log.fileName}.notes.json")

    /** Returns the path of the file to which this computer appends the notes of [log]. */
    fun of(log: Path): Path = log.resolveSibling("${log.fileName}.notes-$computerName.jsonl")

    /**
     * Returns the notes of [log]; none if there is no file with notes. Notes that are damaged or unreadable are missing, and reported as
     * problems.
     */
    fun read(log: Path): ReadNotes {
        val problems = ArrayList<String>()
        val beginning = try {
            beginning(log)
        } catch (e: NotesException) {
            problems += e.message.orEmpty()
            emptyList()
        }
        return ReadNotes(NoteHistory.of(beginning, changes(log, problems)), problems)
    }

    /**
     * Stores [notes] as the notes of [log], merged with changes by others. [read] holds the notes as they were read before. Returns the
     * stored notes.
     *
     * @throws IOException if the file cannot be written; the message is a sentence for the user.
     */
    fun update(log: Path, notes: List<Note>, read: List<Note>): ReadNotes {
        val author = System.getProperty("user.name").orEmpty()
        val made = read(log).history.changesTo(notes, read, author, ::changeTime) { UUID.randomUUID().toString() }
        val lines = made.map { it.toLine() }
        if (lines.isNotEmpty()) appendLines(of(log), lines)
        return read(log)
    }

    private fun changes(log: Path, problems: MutableList<String>): List<NoteChange> = try {
        filesOf(log)
    } catch (e: UnreadableFileException) {
        problems += e.message
        emptyList()
    }.flatMap { file ->
        try {
            val lines = noteChangesOf(appendedText(file))
            lines.problemOf("${file.fileName}")?.let(problems::add)
            lines.changes
        } catch (e: UnreadableFileException) {
            problems += e.message
            emptyList()
        }
    }

    private fun filesOf(log: Path): List<Path> {
        val folder = log.toAbsolutePath().parent
        val begin = "${log.fileName}.notes"
        fun isOne(file: Path) = file.fileName.toString().let { it.startsWith(begin) && it.endsWith(".jsonl") } && Files.isRegularFile(file)
        return reading(folder) { Files.newDirectoryStream(folder, ::isOne).use { it.toList() } }
    }

    private fun beginning(log: Path): List<Note> {
        val file = beginningOf(log)
        return try {
            if (!Files.isRegularFile(file)) return emptyList()
            if (Files.size(file) > MAX_BYTES) throw NotesException("It is too large.")
            notesOfJson(Files.readString(file))
        } catch (e: NotesException) {
            throw NotesException("The notes in ${file.fileName} are damaged: ${e.message} Repair the file, or delete it.")
        } catch (_: CharacterCodingException) {
            throw NotesException("The notes in ${file.fileName} are damaged: they are not text. Repair the file, or delete it.")
        } catch (e: IOException) {
            throw NotesException("The notes in ${file.fileName} cannot be read: ${e.message}")
        }
    }
}

/**
 * The notes of a log, as read from its files.
 *
 * @property history the notes, and the changes to removed ones.
 * @property problems the parts that could not be read, each as a sentence.
 */
class ReadNotes(val history: NoteHistory, val problems: List<String>) {
    /** The notes, ordered by x. */
    val notes: List<Note> = history.notes
}
