package badlog.window.settings

import androidx.compose.runtime.snapshotFlow
import badlog.files.writeAtomically
import badlog.window.state.StateHolder
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

    /** Returns what was stored. */
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
     * Stores those of [settings] that changed since [before]; the rest stays as another window has stored it. Writes atomically.
     *
     * @throws IOException if it cannot be written.
     */
    fun write(settings: Settings, before: Settings) {
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
 * @param own the files of badlog, of which one stores the settings between starts.
 * @param kept the content of that file.
 */
internal class SettingsStore(private val own: OwnFiles, private val kept: Settings = Settings()) : StateHolder<Settings>(kept) {
    private val file = SettingsFile(own.folders.settings.resolve(SettingsFile.NAME))
    private var written = kept

    /** Writes each change a moment after it was made, until cancelled. */
    @OptIn(FlowPreview::class)
    suspend fun autosave() = snapshotFlow { state }.dropWhile { it == kept }.debounce(QUIET_MILLIS).collectLatest { settings ->
        try {
            withContext(Dispatchers.IO) { file.write(settings, written) }
            written = settings
        } catch (e: IOException) {
            own.cannotSave(e)
        }
    }

    /** Writes immediately what would otherwise be written a moment later, because the window is about to close. */
    fun saveNow() {
        try {
            file.write(state, written)
        } catch (_: IOException) {
            // There is no longer a window to report it in.
        }
    }

    private companion object {
        const val QUIET_MILLIS = 400L
    }
}
