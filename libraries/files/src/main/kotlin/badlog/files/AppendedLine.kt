package badlog.files

import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.charset.CodingErrorAction
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption

/**
 * Appends [lines] to [file] in one piece. The file is created if it does not exist. If its last line was cut off, for example because a USB
 * stick was pulled out, [lines] begin on a new line. Several programs may append to one file at the same time.
 *
 * @throws UnwritableFileException if it cannot be written.
 */
public fun appendLines(file: Path, lines: List<String>) {
    try {
        val text = lines.joinToString("", if (isCut(file)) "\n" else "") { "$it\n" }
        // Only the system knows where the file ends when the bytes arrive.
        FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND).use { channel ->
            val bytes = ByteBuffer.wrap(text.encodeToByteArray())
            while (bytes.hasRemaining()) channel.write(bytes)
            channel.force(true)
        }
    } catch (e: IOException) {
        throw unwritable(file, e)
    }
}

/** Returns whether [file] ends within a line. */
private fun isCut(file: Path): Boolean {
    if (!Files.exists(file)) return false
    return FileChannel.open(file).use { channel ->
        val last = ByteBuffer.allocate(1)
        val size = channel.size()
        size > 0 && channel.read(last, size - 1) == 1 && last[0] != '\n'.code.toByte()
    }
}

/**
 * Returns the text of [file], to which lines are appended. Bytes that are not UTF-8 become replacement characters, so that only their line is
 * lost.
 *
 * @throws UnreadableFileException if it cannot be read, or is larger than 16 MB.
 */
public fun appendedText(file: Path): String = reading(file) {
    if (Files.size(file) > MAX_BYTES) throw IOException("it is larger than 16 MB")
    Charsets.UTF_8.newDecoder().onMalformedInput(CodingErrorAction.REPLACE).onUnmappableCharacter(CodingErrorAction.REPLACE)
        .decode(ByteBuffer.wrap(Files.readAllBytes(file))).toString().removePrefix("\uFEFF")
}

/** Far more than people write: a line has some 200 bytes. */
private const val MAX_BYTES = 16L shl 20
