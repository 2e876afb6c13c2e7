package badlog.window.settings

import androidx.compose.runtime.snapshotFlow
import badlog.files.UserFolders
import badlog.files.locking
import badlog.files.writeAtomically
import badlog.window.files.obstacleTo
import badlog.window.state.StateHolder
import badlog.window.task.FileWrites
import badlog.window.task.Notices
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.FlowPreview
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.debounce
import kotlinx.coroutines.flow.dropWhile
import kotlinx.coroutines.withContext
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Stores [Settings] in a file of the user. A missing or damaged file is ignored. */
internal class SettingsFile(private val file: Path) {
    private val json = Json {
        ignoreUnknownKeys = true
        prettyPrint = true
        coerceInputValues = true
    }

    /** Returns the stored settings, or the defaults. */
    fun read(): Settings = readWhole() ?: Settings()

    private fun readWhole(): Settings? = try {
        json.decodeFromString(Files.readString(file))
    } catch (_: IOException) {
        null
    } catch (_: SerializationException) {
        null
    } catch (_: IllegalArgumentException) {
        null
    }

    /**
     * Stores the [settings] that have changed since [before], atomically; the rest stays as another window has stored it.
     *
     * @throws IOException if it cannot be written.
     */
    fun write(settings: Settings, before: Settings) = locking(file.toAbsolutePath().parent) {
        val both = readWhole()?.let { merged(settings, before, it) } ?: settings
        writeAtomically(file) { it.write(json.encodeToString(Settings.serializer(), both).encodeToByteArray()) }
    }

    companion object {
        /** The name of the file. */
        const val NAME = "settings.json"
    }
}

/**
 * The user's settings.
 *
 * @param own the files of badlog, including the one for settings.
 * @param writes writes that file.
 * @param kept the content of that file.
 */
internal class SettingsStore(private val own: OwnFiles, private val writes: FileWrites, private val kept: Settings = Settings()) :
    StateHolder<Settings>(kept) {
    private val file = SettingsFile(own.folders.settings.resolve(SettingsFile.NAME))

    /** The settings that this window has written to the file; only [writes] use it. */
    private var written = kept

    /** Writes each change a moment after it was made, until cancelled. */
    @OptIn(FlowPreview::class)
    suspend fun autosave() = snapshotFlow { state }.dropWhile { it == kept }.debounce(QUIET_MILLIS).collectLatest { settings ->
        try {
            save(settings)
        } catch (e: IOException) {
            own.cannotSave(e)
        }
    }

    /** Writes immediately instead of a moment later, because the window is about to close. */
    fun saveNow() = writes.finish {
        try {
            save(state)
        } catch (_: IOException) {
            // The window that could report it is closing.
        }
    }

    private suspend fun save(settings: Settings) = writes.write {
        file.write(settings, written)
        written = settings
    }
}

/**
 * The files that badlog keeps for its next start. Use it only on the window's thread. The window works without them; a single sentence
 * reports the data that is not kept.
 *
 * @property folders the folders of these files.
 */
internal class OwnFiles(val folders: UserFolders, private val notices: Notices) {
    private var isReported = false

    /** Reports the data that cannot be kept, if a folder cannot be written. */
    suspend fun check() {
        val (settings, answers) = withContext(Dispatchers.IO) { obstacleTo(folders.settings) to obstacleTo(folders.answers) }
        if (settings != null) isReported = true
        val obstacles = listOfNotNull(settings, answers).distinct()
        val lost = when {
            obstacles.isEmpty() -> return
            answers == null -> "Settings and layouts"
            settings == null -> "Stored results for logs"
            else -> "Settings, layouts and stored results for logs"
        }
        notices.complain("$lost cannot be kept for the next start; ${obstacles.joinToString(" and ", transform = ::remedyFor)}.")
    }

    /** Reports the failure [e] to save settings or layouts, unless one was reported before. */
    suspend fun cannotSave(e: IOException) {
        if (!isReported) check()
        if (isReported) return
        isReported = true
        notices.complain("Settings and layouts cannot be saved: ${e.message}")
    }
}

private fun remedyFor(obstacle: Path) = if (Files.isDirectory(obstacle)) {
    "change the permissions of $obstacle, so that you may write there"
} else {
    "rename the file $obstacle, because a folder must be there"
}

private const val QUIET_MILLIS = 400L
