package badlog.lib

import java.io.File
import java.time.Instant
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import kotlin.random.Random

/** The names of a robot's logs, as WPILib names its own: `FRC_20260307_140212_OHCL_Q42.bag`, times in UTC. */
internal object LogName {
    private const val PROVISIONAL = "FRC_TBD_"
    private val LOG = Regex("FRC_.*\\.bag(\\.gz)?")
    private val TIME = DateTimeFormatter.ofPattern("yyyyMMdd_HHmmss").withZone(ZoneOffset.UTC)

    /** A name for a log whose time is unknown. */
    fun provisional(): String = PROVISIONAL + Random.nextLong().toULong().toString(16).padStart(16, '0')

    /** The name of a log that began at [time]; [event] and [match] may be empty. */
    fun of(time: Instant, event: String, match: String): String =
        listOf("FRC", TIME.format(time), safe(event), safe(match)).filter { it.isNotEmpty() }.joinToString("_")

    fun isLog(name: String): Boolean = LOG.matches(name)

    fun isProvisional(name: String): Boolean = name.startsWith(PROVISIONAL)

    /** A file of that [name] in [folder] that does not exist. */
    fun free(folder: File, name: String, ending: String): File = generateSequence(1) { it + 1 }
        .map { File(folder, if (it == 1) name + ending else "${name}_$it$ending") }
        .first { !it.exists() }

    // The field's system names events; that it will not contain a slash is no reason to believe it.
    private fun safe(text: String) = text.filter { it.isLetterOrDigit() || it == '-' }
}
