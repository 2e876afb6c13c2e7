package badlog.file

import badlog.recording.Problem
import badlog.revlog.RevlogConversion
import org.tukaani.xz.XZ
import java.io.BufferedOutputStream
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * A log as the readers of this library know it.
 *
 * @property path the log itself, or a WPILOG made of it.
 * @property name what to call it: of a WPILOG that was made, that of the log with its ending.
 * @property problems what was wrong in the log and does not show in the WPILOG that was made of it.
 */
public class Unpacked internal constructor(public val path: Path, public val name: String, public val problems: List<Problem>)

/**
 * Runs [work] with the log [file], or with the WPILOG that it holds in another form, which is there only meanwhile: a `.wpilogxz` is
 * one that was compressed with xz, a `.revlog` of REV's devices can be written as one, and of a `.hoot` of CTRE's devices CTRE's own
 * program makes one. All but the last are known by their content.
 *
 * @param name what the log is called, where the file has another name meanwhile.
 * @param checkpoint is called now and then while a WPILOG is made, and may throw to give up.
 * @throws UnreadableFileException when the file cannot be read, or no WPILOG can be made of it.
 * @throws InterruptedException when the thread was interrupted.
 */
public fun <T> unpacked(file: Path, checkpoint: () -> Unit = {}, name: String = file.fileName.toString(), work: (Unpacked) -> T): T {
    val head = reading(file) { Files.newInputStream(file).use { it.readNBytes(SIGNATURE_SIZE) } }
    val isXz = head.size >= XZ.HEADER_MAGIC.size && XZ.HEADER_MAGIC.indices.all { head[it] == XZ.HEADER_MAGIC[it] }
    val make: (Path) -> List<Problem> = when {
        isXz -> { made -> writing(made) { outputOf(made).use { inflateXz(file, it, checkpoint) } } }

        RevlogConversion.isRevlog(head) -> { made -> writing(made) { outputOf(made).use { convertRevlog(file, it, checkpoint) } } }

        LogName.of(name).ending.equals(LogName.HOOT, ignoreCase = true) -> { made ->
            Owlet.convert(file, made, checkpoint)
        }

        else -> return work(Unpacked(file, name, emptyList()))
    }
    val made = newMadeFile(WPILOG)
    try {
        val problems = make(made)
        return work(Unpacked(made, name.dropLast(LogName.of(name).run { name.length - stem.length }) + WPILOG, problems))
    } finally {
        Files.deleteIfExists(made)
    }
}

private fun outputOf(file: Path): OutputStream = BufferedOutputStream(Files.newOutputStream(file), 1 shl 16)

private fun convertRevlog(file: Path, out: OutputStream, checkpoint: () -> Unit): List<Problem> {
    val conversion = RevlogConversion(out)
    reading(file) { Files.newInputStream(file) }.use { stream ->
        val piece = ByteArray(1 shl 16)
        while (true) {
            val size = reading(file) { stream.read(piece) }
            if (size < 0) break
            conversion.accept(piece, size)
            checkpoint()
        }
    }
    return conversion.finish()
}

private const val WPILOG = ".wpilog"
private const val SIGNATURE_SIZE = RevlogConversion.SIGNATURE_SIZE
