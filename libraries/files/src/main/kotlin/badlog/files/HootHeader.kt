package badlog.files

import java.nio.file.Files
import java.nio.file.Path

/**
 * The known part of the first bytes of a `.hoot`, CTRE's log; CTRE does not publish the format.
 *
 * @property bus the name of the CAN bus, in bytes 0 to 63.
 * @property compliancy the version of CTRE's converter that can read it, in byte 70.
 */
internal class HootHeader private constructor(val bus: String, val compliancy: Int) {
    /** Whether it is from before Phoenix 2024; no converter reads such logs. */
    val isTooOld: Boolean get() = compliancy < OLDEST

    companion object {
        private const val BUS_SIZE = 64
        private const val COMPLIANCY = 70
        private const val OLDEST = 6

        /** Returns the header of [hoot]. Null if the file is too short to have one, or the name of its bus is not text. */
        fun of(hoot: Path): HootHeader? {
            val bytes = reading(hoot) { Files.newInputStream(hoot).use { it.readNBytes(COMPLIANCY + 1) } }
            if (bytes.size <= COMPLIANCY) return null
            val bus = String(bytes, 0, BUS_SIZE, Charsets.ISO_8859_1).substringBefore('\u0000')
            if (bus.isEmpty() || bus.any { it !in ' '..'~' }) return null
            return HootHeader(bus, bytes[COMPLIANCY].toInt() and 0xff)
        }
    }
}
