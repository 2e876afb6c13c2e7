package badlog.files

import badlog.core.recording.Problem
import badlog.core.recording.RecordingFormat
import badlog.formats.revlog.RevlogConversion
import badlog.formats.revlog.RevlogFormat
import org.tukaani.xz.XZ
import java.io.BufferedOutputStream
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * A log in a form that this library can read.
 *
 * @property path the log itself, or a WPILOG made from it.
 * @property name its name: for a converted WPILOG, the name of the log with the ending of a WPILOG.
 * @property format the format from which the WPILOG was made; null for the log itself, and for a format that badlog cannot read by itself.
 * @property problems the problems of the log that the converted WPILOG does not show.
 */
public class Unpacked internal constructor(
    public val path: Path,
    public val name: String,
    public val format: RecordingFormat?,
    public val problems: List<Problem>,
)

/**
 * Runs [work] with the log [file], or with a temporary WPILOG made from it. A `.wpilogxz` is a WPILOG compressed with xz, a `.revlog` of
 * REV's devices is converted to one, and CTRE's own program converts a `.hoot` of CTRE's devices. All but the last are recognized by their
 * content.
 *
 * @param name the name of the log, if the file temporarily has another one.
 * @param maker makes a WPILOG from a file that contains several logs; null if such files are not read.
 * @param checkpoint called from time to time while a WPILOG is made; may throw to cancel.
 * @throws UnreadableFileException if the file cannot be read, or not converted to a WPILOG.
 * @throws UnwritableFileException if the WPILOG cannot be written, such as on a full disk.
 * @throws InterruptedException if the thread was interrupted.
 */
public fun <T> unpacked(
    file: Path,
    checkpoint: () -> Unit = {},
    name: String = file.fileName.toString(),
    maker: LogMaker? = null,
    work: (Unpacked) -> T,
): T {
    val head = reading(file) { Files.newInputStream(file).use { it.readNBytes(SIGNATURE_SIZE) } }
    val isXz = head.size >= XZ.HEADER_MAGIC.size && XZ.HEADER_MAGIC.indices.all { head[it] == XZ.HEADER_MAGIC[it] }
    val isRevlog = !isXz && RevlogFormat.matches(head, head.size)
    val make: (Path) -> List<Problem> = when {
        maker != null && maker.isSource(file, head) -> { made -> maker.make(file, made, checkpoint) }

        isXz -> { made -> writing(made) { outputOf(made).use { inflateXz(file, it, checkpoint) } } }

        isRevlog -> { made -> writing(made) { outputOf(made).use { convertRevlog(file, it, checkpoint) } } }

        LogName.of(name).ending.equals(LogName.HOOT, ignoreCase = true) -> { made ->
            Owlet.convert(file, made, checkpoint)
        }

        else -> return work(Unpacked(file, name, null, emptyList()))
    }
    val made = newMadeFile(WPILOG)
    try {
        val problems = make(made)
        val madeName = name.dropLast(LogName.of(name).run { name.length - stem.length }) + WPILOG
        return work(Unpacked(made, madeName, RevlogFormat.takeIf { isRevlog }, problems))
    } finally {
        Files.deleteIfExists(made)
    }
}

private fun outputOf(file: Path): OutputStream = BufferedOutputStream(Files.newOutputStream(file), 1 shl 16)

private fun convertRevlog(file: Path, out: OutputStream, checkpoint: () -> Unit): List<Problem> {
    val conversion = RevlogConversion { bytes, size -> out.write(bytes, 0, size) }
    reading(file) { Files.newInputStream(file) }.use { stream ->
        val piece = ByteArray(1 shl 16)
        while (true) {
            val size = reading(file) { stream.read(piece) }
            if (size < 0) break
            conversion.accept(piece, 0, size)
            checkpoint()
        }
    }
    return conversion.finish()
}

private const val WPILOG = ".wpilog"
private val SIGNATURE_SIZE = maxOf(RevlogFormat.signatureSize, XZ.HEADER_MAGIC.size)
