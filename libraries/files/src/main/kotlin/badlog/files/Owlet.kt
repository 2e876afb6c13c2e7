package badlog.files

import badlog.core.recording.Problem
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/**
 * CTRE's program that converts a `.hoot`, a format that CTRE does not publish, to a WPILOG. It is never part of badlog. If [one is
 * found][OwletSearch], it is run as described in its help: `owlet INPUT OUTPUT -f wpilog`.
 */
internal object Owlet {
    private val search by lazy { OwletSearch() }

    /** Whether the program is found on this computer, so that a `.hoot` can be read. */
    val isInstalled: Boolean by lazy { search.any != null }

    /** Converts [hoot] to the WPILOG [made] with the program found for it. */
    fun convert(hoot: Path, made: Path, checkpoint: () -> Unit): List<Problem> =
        convert(hoot, made, checkpoint, programFor(hoot, search).toString())

    /** Returns the program for [hoot]; if none is found, the exception says where to get it. */
    internal fun programFor(hoot: Path, search: OwletSearch): Path {
        val header = HootHeader.of(hoot)
        search.programFor(header?.compliancy)?.let { return it }
        throw UnreadableFileException(hoot, sentenceFor(hoot, header))
    }

    private fun sentenceFor(hoot: Path, header: HootHeader?): String = when {
        header == null -> missing(hoot, "")

        header.isTooOld ->
            "$hoot, of the CAN bus “${header.bus}”, was written before Phoenix 2024, whose logs CTRE's owlet does not convert; use the " +
                "Log Extractor in Phoenix Tuner of that year."

        else -> missing(hoot, " for its version C${header.compliancy}")
    }

    private fun missing(hoot: Path, version: String) =
        "$hoot can only be read by CTRE's program owlet$version; AdvantageScope downloads it when it opens such a log, or put it on the " +
            "PATH or name it in ${OwletSearch.SETTING}, or convert the log to a WPILOG in Phoenix Tuner's Log Extractor."

    /** Converts [hoot] to the WPILOG [made] with [program]. */
    internal fun convert(hoot: Path, made: Path, checkpoint: () -> Unit, program: String): List<Problem> {
        val said = newMadeFile(".txt")
        try {
            val process = start(hoot, made, program, said)
            try {
                while (!process.waitFor(STEP, TimeUnit.MILLISECONDS)) checkpoint()
            } finally {
                process.destroyForcibly()
            }
            if (process.exitValue() != 0 || Files.size(made) == 0L) {
                val words = Files.readString(said, Charsets.ISO_8859_1).lines().lastOrNull { it.isNotBlank() }?.trim()?.take(MAX_QUOTED)
                throw UnreadableFileException(
                    hoot,
                    "CTRE's owlet did not convert $hoot (${words ?: "it gave no reason"}); " +
                        "try a newer owlet, or Phoenix Tuner's Log Extractor.",
                )
            }
            return emptyList()
        } finally {
            Files.deleteIfExists(said)
        }
    }

    private fun start(hoot: Path, made: Path, program: String, said: Path): Process = try {
        ProcessBuilder(program, hoot.toAbsolutePath().toString(), made.toString(), "-f", "wpilog")
            .redirectErrorStream(true).redirectOutput(said.toFile()).start().also { it.outputStream.close() }
    } catch (e: IOException) {
        throw UnreadableFileException(hoot, missing(hoot, ""), e)
    }

    /** The interval between checks for cancellation, in ms. */
    private const val STEP = 50L

    /** The maximum number of characters quoted from its output. */
    private const val MAX_QUOTED = 200
}
