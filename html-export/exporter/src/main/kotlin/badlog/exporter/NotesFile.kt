package badlog.exporter

import badlog.files.writeAtomically
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NotesException
import badlog.viewer.choices.note.notesMergedWith
import badlog.viewer.choices.note.notesOfJson
import badlog.viewer.choices.note.toJson
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/** The file with the notes of one log, beside it: `q42.bag.notes.json` for `q42.bag`. */
object NotesFile {
    /** Larger files are not notes of a log. */
    private const val MAX_BYTES = 16L shl 20

    /** Returns the path of the notes of [log], whether or not they exist. */
    fun of(log: Path): Path = log.resolveSibling("${log.fileName}.notes.json")

    /**
     * Returns the notes of [log], in the order of x; none if it has no such file.
     *
     * @throws NotesException with a sentence for the user, if the file is damaged or cannot be read.
     */
    fun read(log: Path): List<Note> {
        val file = of(log)
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

    /**
     * Stores [notes] as those of [log], with what others have changed since they were [read]. Returns what is stored.
     *
     * @throws IOException with a sentence for the user, if it cannot be written.
     * @throws NotesException if somebody has damaged the file meanwhile; it stays as it is.
     */
    fun update(log: Path, notes: List<Note>, read: List<Note>): List<Note> {
        val merged = notes.notesMergedWith(read(log), read)
        write(log, merged)
        return merged
    }

    /**
     * Stores [notes] as those of [log]; the file is deleted with the last of them.
     *
     * @throws IOException with a sentence for the user, if it cannot be written.
     */
    fun write(log: Path, notes: List<Note>) {
        val file = of(log)
        if (notes.isEmpty()) {
            Files.deleteIfExists(file)
        } else {
            writeAtomically(file) { it.write(notes.toJson().encodeToByteArray()) }
        }
    }
}
