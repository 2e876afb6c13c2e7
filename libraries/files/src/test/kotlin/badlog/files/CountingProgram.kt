package badlog.files

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists

/**
 * Counts in the folder that is the first of [args], as often as the second says. It begins as soon as its input is closed, and writes a letter when
 * it can begin.
 */
fun main(args: Array<String>) {
    val (folder, times) = args
    print("r")
    System.out.flush()
    System.`in`.read()
    countIn(Path.of(folder), times.toInt())
}

/** Adds 1 to the number in a file in [folder], [times] times. */
internal fun countIn(folder: Path, times: Int) {
    val file = folder.resolve("count")
    repeat(times) {
        locking(folder) {
            val before = if (file.exists()) Files.readString(file).toInt() else 0
            writeAtomically(file) { it.write("${before + 1}".encodeToByteArray()) }
        }
    }
}
