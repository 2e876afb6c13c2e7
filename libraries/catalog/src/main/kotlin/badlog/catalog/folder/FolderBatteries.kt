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
 * A team's records of its batteries in the nearest file called `batteries.toml`, in a log's folder or above it.
 *
 * @property problems the reasons why files are not used, as sentences.
 */
class FolderBatteries private constructor(private val byFolder: Map<Path, BatteriesOfFolder>, val problems: List<String>) {
    /** The content of a file in [folder]. */
    private class BatteriesOfFolder(val folder: Path, val batteries: TeamBatteries)

    /** All batteries, each once. */
    val batteries: List<TeamBattery> get() = byFolder.values.flatMap { it.batteries.batteries }.distinctBy { it.name.lowercase() }

    /** Returns the recorded battery of a match with the logs [files]; null if none is recorded. */
    fun usedFor(files: List<Path>, match: String?): String? =
        files.groupBy { byFolder[folderOf(it)] }.firstNotNullOfOrNull { (written, own) ->
            written?.batteries?.usedFor(own.map { placeFrom(written.folder, it) }, match)
        }

    companion object {
        /** No records. */
        val NONE: FolderBatteries = FolderBatteries(emptyMap(), emptyList())

        /** Returns the records for [logs], up to the folder [top]; null means only the logs' own folders. */
        fun of(logs: Collection<Path>, top: Path?): FolderBatteries {
            val problems = LinkedHashSet<String>()
            val read = HashMap<Path, BatteriesOfFolder?>()
            val byFolder = HashMap<Path, BatteriesOfFolder>()
            for (folder in logs.mapTo(LinkedHashSet(), ::folderOf)) {
                val file = nearestTo(folder.resolve(BatteriesFile.NAME), top) { "" }.file ?: continue
                val written = read.getOrPut(file) {
                    val nearest = nearestTo(file, null, BatteriesFile::parse)
                    nearest.problem?.let { problems += "$file is not used: $it" }
                    nearest.found?.let { BatteriesOfFolder(folderOf(file), it) }
                }
                if (written != null) byFolder[folder] = written
            }
            return FolderBatteries(byFolder, problems.toList())
        }

        /**
         * Records [battery] as the one used in a match with the logs [logs]. An empty name removes the record for the logs, or for [match].
         * The file is the nearest one up to [top], otherwise a new one beside the log.
         *
         * @return the reason for a failure, as a sentence; null on success.
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

        /** Returns the path of [log] relative to [folder], with slashes; its name if it is not below. */
        private fun placeFrom(folder: Path, log: Path): String {
            val own = log.toAbsolutePath().normalize()
            return if (own.startsWith(folder)) folder.relativize(own).joinToString("/") else "${log.fileName}"
        }
    }
}
