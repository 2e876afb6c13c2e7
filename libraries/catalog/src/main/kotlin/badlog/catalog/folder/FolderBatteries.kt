package badlog.catalog.folder

import badlog.files.writeAtomically
import badlog.rules.BatteriesFile
import badlog.rules.NearestFile
import badlog.rules.RulesException
import badlog.signals.battery.TeamBatteries
import badlog.signals.battery.TeamBattery
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * What a team wrote down about its batteries in the nearest file called `batteries.toml`: in a log's folder, or in one above it.
 *
 * @property problems why a file is not used, as sentences.
 */
class FolderBatteries private constructor(private val byFolder: Map<Path?, TeamBatteries>, val problems: List<String>) {
    /** All batteries, each once. */
    val batteries: List<TeamBattery> get() = byFolder.values.flatMap { it.batteries }.distinctBy { it.name }

    /** Returns the battery for the log [file], of [match] if that is not null, as written down; null if it is not. */
    fun usedFor(file: Path, match: String?): String? = byFolder[file.parent]?.usedFor("${file.fileName}", match)

    companion object {
        /** Nothing is written down. */
        val NONE: FolderBatteries = FolderBatteries(emptyMap(), emptyList())

        /** Returns what is written down for [logs], up to the folder [top], which is null for the logs' own folders only. */
        fun of(logs: Collection<Path>, top: Path?): FolderBatteries {
            val problems = LinkedHashSet<String>()
            val byFolder = logs.groupBy { it.parent }.mapNotNull { (folder, files) ->
                val nearest = nearestTo(files.first(), top, BatteriesFile::parse)
                nearest.problem?.let { problems += "${nearest.file} is not used: $it" }
                nearest.found?.let { folder to it }
            }
            return FolderBatteries(byFolder.toMap(), problems.toList())
        }

        /**
         * Writes down that [battery] was in the robot for [log]; an empty name takes that back. The file is the nearest one up to [top], or
         * else a new one beside the log.
         *
         * @return why that is not done, as a sentence; null if it is.
         */
        fun assign(battery: String, log: Path, top: Path?): String? {
            val nearest = nearestTo(log, top) { text -> text.also(BatteriesFile::parse) }
            val file = nearest.file ?: log.resolveSibling(BatteriesFile.NAME)
            if (nearest.problem != null) return "$file is not changed: ${nearest.problem}"
            return try {
                val text = BatteriesFile.withUse(nearest.found.orEmpty(), "${log.fileName}", battery)
                writeAtomically(file) { it.write(text.encodeToByteArray()) }
                null
            } catch (e: RulesException) {
                e.message
            } catch (_: IOException) {
                "$file cannot be written; check the permissions of its folder."
            }
        }

        private fun <T> nearestTo(log: Path, top: Path?, parse: (String) -> T) =
            NearestFile.of(log, top, { it.resolve(BatteriesFile.NAME).takeIf(Files::isRegularFile) }, parse)
    }
}
