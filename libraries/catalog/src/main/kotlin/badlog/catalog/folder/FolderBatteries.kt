package badlog.catalog.folder

import badlog.files.UnwritableFileException
import badlog.files.writeAtomically
import badlog.rules.BatteriesFile
import badlog.rules.NearestFile
import badlog.rules.RulesException
import badlog.signals.battery.TeamBatteries
import badlog.signals.battery.TeamBattery
import java.nio.file.Files
import java.nio.file.Path

/**
 * What a team wrote down about its batteries in the nearest file called `batteries.toml`: in a log's folder, or in one above it.
 *
 * @property problems why a file is not used, as sentences.
 */
class FolderBatteries private constructor(private val byFolder: Map<Path, Written>, val problems: List<String>) {
    /** The content of a file in [folder]. */
    private class Written(val folder: Path, val batteries: TeamBatteries)

    /** All batteries, each once. */
    val batteries: List<TeamBattery> get() = byFolder.values.flatMap { it.batteries.batteries }.distinctBy { it.name.lowercase() }

    /** Returns the battery of a match, whose logs are [files], as written down; null if it is not. */
    fun usedFor(files: List<Path>, match: String?): String? =
        files.groupBy { byFolder[folderOf(it)] }.firstNotNullOfOrNull { (written, own) ->
            written?.batteries?.usedFor(own.map { placeFrom(written.folder, it) }, match)
        }

    companion object {
        /** Nothing is written down. */
        val NONE: FolderBatteries = FolderBatteries(emptyMap(), emptyList())

        /** Returns what is written down for [logs], up to the folder [top], which is null for the logs' own folders only. */
        fun of(logs: Collection<Path>, top: Path?): FolderBatteries {
            val problems = LinkedHashSet<String>()
            val read = HashMap<Path, Written?>()
            val byFolder = HashMap<Path, Written>()
            for (folder in logs.mapTo(LinkedHashSet(), ::folderOf)) {
                val file = nearestTo(folder.resolve(BatteriesFile.NAME), top) { "" }.file ?: continue
                val written = read.getOrPut(file) {
                    val nearest = nearestTo(file, null, BatteriesFile::parse)
                    nearest.problem?.let { problems += "$file is not used: $it" }
                    nearest.found?.let { Written(folderOf(file), it) }
                }
                if (written != null) byFolder[folder] = written
            }
            return FolderBatteries(byFolder, problems.toList())
        }

        /**
         * Writes down that [battery] was in the robot for a match, whose logs are [logs]; an empty name takes back what was written down for
         * them, or for [match]. The file is the nearest one up to [top], or else a new one beside the log.
         *
         * @return why that is not done, as a sentence; null if it is.
         */
        @Synchronized
        fun assign(battery: String, logs: List<Path>, match: String?, top: Path?): String? {
            val nearest = nearestTo(logs.first(), top) { text -> text.also(BatteriesFile::parse) }
            val file = nearest.file ?: folderOf(logs.first()).resolve(BatteriesFile.NAME)
            if (nearest.problem != null) return "$file is not changed: ${nearest.problem}"
            return try {
                val before = nearest.found.orEmpty()
                val places = logs.map { placeFrom(folderOf(file), it) }
                val keys = if (battery.isEmpty()) places + listOfNotNull(match) else places
                val text = keys.fold(before) { made, key -> BatteriesFile.withUse(made, key, battery) }
                if (text != before) writeAtomically(file) { it.write(text.encodeToByteArray()) }
                null
            } catch (e: RulesException) {
                e.message
            } catch (e: UnwritableFileException) {
                e.message
            }
        }

        private fun <T> nearestTo(log: Path, top: Path?, parse: (String) -> T) =
            NearestFile.of(log, top, { it.resolve(BatteriesFile.NAME).takeIf(Files::isRegularFile) }, parse)

        private fun folderOf(file: Path): Path = file.toAbsolutePath().normalize().parent

        /** Returns where [log] is from [folder] on, with slashes; its name if it is not below. */
        private fun placeFrom(folder: Path, log: Path): String {
            val own = log.toAbsolutePath().normalize()
            return if (own.startsWith(folder)) folder.relativize(own).joinToString("/") else "${log.fileName}"
        }
    }
}
