package badlog.html.note

import badlog.file.writeAtomically
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/** The file with the notes of one log, beside it: `q42.bag.notes.json` for `q42.bag`. */
public object NotesFile {
    /** Larger files are not the notes of a log. */
    private const val MAX_BYTES = 16L shl 20

    /** Where the notes of [log] are, if it has any. */
    public fun of(log: Path): Path = log.resolveSibling("${log.fileName}.notes.json")

    /**
     * The notes of [log], in the order of x; none where it has no file of them.
     *
     * @throws NotesException with a sentence for the person, when the file is damaged, or cannot be read.
     */
    public fun read(log: Path): List<Note> {
        val file = of(log)
        return try {
            if (!Files.isRegularFile(file)) return emptyList()
            if (Files.size(file) > MAX_BYTES) throw NotesException("It is too large.")
            notesOfJson(Files.readString(file))
        } catch (e: NotesException) {
            throw NotesException("The notes in ${file.fileName} are damaged: ${e.message} Mend the file, or delete it.")
        } catch (_: CharacterCodingException) {
            throw NotesException("The notes in ${file.fileName} are damaged: they are not text. Mend the file, or delete it.")
        } catch (e: IOException) {
            throw NotesException("The notes in ${file.fileName} cannot be read: ${e.message}")
        }
    }

    /**
     * Keeps [notes] as those of [log]; the file goes with the last of them.
     *
     * @throws IOException with a sentence for the person, when it cannot be written.
     */
    public fun write(log: Path, notes: List<Note>) {
        val file = of(log)
        if (notes.isEmpty()) {
            Files.deleteIfExists(file)
        } else {
            writeAtomically(file) { it.write(notes.toJson().encodeToByteArray()) }
        }
    }
}
