package badlog.catalog.todo

import badlog.files.UnreadableFileException
import badlog.files.UnwritableFileException
import badlog.files.reading
import badlog.files.safeName
import badlog.viewer.todo.CHECKLIST_FILE
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoLines
import badlog.viewer.todo.checklistOf
import badlog.viewer.todo.toLine
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.charset.CodingErrorAction
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * A team's list beside the logs in [folder]. Each computer appends to a file of its own, so that a synced folder or git has nothing to
 * resolve; all of them are read. Lines are never changed. Do not call it on the window's thread.
 *
 * @param computer the name of this computer.
 */
class TodoFolder(private val folder: Path, computer: String = computerName()) {
    /** The file that this computer writes. */
    val file: Path = folder.resolve("$BEGIN-${safeName(computer).lowercase().replace(' ', '-')}$ENDING")

    /**
     * Returns what all computers wrote.
     *
     * @throws UnreadableFileException if the folder cannot be listed.
     */
    fun read(): TodoFiles {
        val changes = ArrayList<TodoChange>()
        val problems = ArrayList<String>()
        for (file in files()) {
            try {
                val lines = TodoLines.of(textOf(file))
                changes += lines.changes
                unreadableText(file, lines.unreadable)?.let(problems::add)
            } catch (e: UnreadableFileException) {
                problems += e.message
            }
        }
        val checklist = try {
            folder.resolve(CHECKLIST_FILE).takeIf(Files::isRegularFile)?.let { checklistOf(textOf(it)) }.orEmpty()
        } catch (e: UnreadableFileException) {
            problems += e.message
            emptyList()
        }
        return TodoFiles(changes, checklist, problems)
    }

    /** Returns what changes whenever [read] would return something else, without reading. */
    fun stamp(): List<Any> = try {
        files().plusElement(folder.resolve(CHECKLIST_FILE)).filter(Files::isRegularFile).map {
            Triple(it, Files.size(it), Files.getLastModifiedTime(it))
        }
    } catch (_: IOException) {
        emptyList()
    }

    /**
     * Appends [change] as one line, in one piece. If the last line was cut off, for example because a stick was pulled out, the new one begins
     * below it.
     *
     * @throws UnwritableFileException if it cannot be written.
     */
    fun append(change: TodoChange) {
        try {
            FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE).use { channel ->
                val size = channel.size()
                val last = ByteBuffer.allocate(1)
                val isCut = size > 0 && channel.read(last, size - 1) == 1 && last[0] != '\n'.code.toByte()
                val line = ByteBuffer.wrap(((if (isCut) "\n" else "") + change.toLine() + "\n").encodeToByteArray())
                var at = size
                while (line.hasRemaining()) at += channel.write(line, at)
                channel.force(true)
            }
        } catch (e: IOException) {
            throw UnwritableFileException(file, "$file cannot be written (${e.message}); check that the folder is not write-protected.", e)
        }
    }

    private fun files(): List<Path> = reading(folder) {
        folder.listDirectoryEntries("$BEGIN*$ENDING").filter(Files::isRegularFile).sortedBy { it.name }
    }

    private fun textOf(file: Path): String = reading(file) {
        if (Files.size(file) > MAX_BYTES) throw IOException("it is larger than 16 MB")
        // Only the lines with damaged letters are lost.
        Charsets.UTF_8.newDecoder().onMalformedInput(CodingErrorAction.REPLACE).onUnmappableCharacter(CodingErrorAction.REPLACE)
            .decode(ByteBuffer.wrap(Files.readAllBytes(file))).toString().removePrefix("\uFEFF")
    }

    private fun unreadableText(file: Path, lines: List<Int>): String? = when (lines.size) {
        0 -> null

        1 -> "Line ${lines[0]} of ${file.name} is skipped: it is damaged, or of a newer badlog. It stays in the file."

        else -> "${lines.size} lines of ${file.name} are skipped, the first is line ${lines[0]}: they are damaged, or of a newer badlog. " +
            "They stay in the file."
    }

    private companion object {
        /** What is after it may also be what a synced folder adds: `badlog-todo-pit (conflicted copy).jsonl`. */
        const val BEGIN = "badlog-todo"
        const val ENDING = ".jsonl"

        /** A line has some 200 bytes. */
        const val MAX_BYTES = 16L shl 20
    }
}

/**
 * The content of the files of a folder that are about what to do.
 *
 * @property changes what all computers wrote, in no particular order, some possibly twice.
 * @property checklist the lines of the team's own checklist.
 * @property problems what could not be read, each as a sentence.
 */
class TodoFiles(
    val changes: List<TodoChange> = emptyList(),
    val checklist: List<String> = emptyList(),
    val problems: List<String> = emptyList(),
)
