package badlog.cli.beside

import badlog.catalog.match.MatchMaker
import badlog.files.filesAround
import badlog.formats.driverstation.isOfDriverStation
import badlog.formats.revlog.RevlogFormat
import badlog.signals.clock.ClockedLog
import badlog.signals.match.files.FileRole
import badlog.signals.match.files.isNamedAlike
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.JsonElement
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString
import badlog.cli.text.jsonOf as fieldsOf

/**
 * A file of a match that lies near its robot's log.
 *
 * @property path its path from the folder of that log, with slashes.
 * @property role its kind, for people.
 */
@Serializable
internal class FileBeside(val path: String, val role: String) {
    /** Whether it is a log, rather than a video. */
    val isLog: Boolean get() = FileRole.of(role) != null
}

/** Finds, by their names, the files of devices and cameras that belong to robots' logs. */
internal class FilesBeside {
    // All logs of a folder have the same files around them.
    private val around = HashMap<Path, List<Path>>()

    /** Returns the files of the match of [robot], which was read from [file]. Returns none for any other log, or for a whole match. */
    fun of(file: Path, robot: ClockedLog): List<FileBeside> {
        if (robot.recording.isOfDriverStation || roleOf(file.fileName.toString()) != null) return emptyList()
        if (MatchMaker.isSource(file)) return emptyList()
        val log = file.toAbsolutePath().normalize()
        return around.getOrPut(log.parent) { filesAround(log) { roleOf(it) != null } }.mapNotNull { path ->
            val role = roleOf(path.fileName.toString())?.takeIf { robot.isNamedAlike("${path.fileName}", "${path.parent.fileName}") }
            role?.let { FileBeside(log.parent.relativize(path).invariantSeparatorsPathString, it) }
        }.sortedBy { it.path }
    }

    /** Returns [files] for programs. */
    fun jsonOf(files: List<FileBeside>): Map<String, JsonElement> = if (files.isEmpty()) emptyMap() else fieldsOf(BesideJson(files))

    private fun roleOf(name: String): String? = ROLES[name.substringAfterLast('.', "").lowercase()]

    private companion object {
        val ROLES = mapOf("hoot" to FileRole.CAN_BUS.role) + RevlogFormat.endings.map { it.removePrefix(".") to FileRole.MOTORS.role } +
            listOf("mp4", "mov", "m4v", "mkv", "webm", "avi", "mts", "mpg", "3gp").map { it to "video" }
    }
}

@Serializable
private class BesideJson(private val beside: List<FileBeside>)
