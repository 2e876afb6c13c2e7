package badlog.viewer.settings

import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption

/** Keeps [Settings] in a file of the user's. A missing or damaged one is as none. */
internal class SettingsFile(private val file: Path) {
    private val json = Json {
        ignoreUnknownKeys = true
        prettyPrint = true
        coerceInputValues = true
    }

    /** What was kept. */
    fun read(): Settings = try {
        json.decodeFromString(Files.readString(file))
    } catch (_: IOException) {
        Settings()
    } catch (_: SerializationException) {
        Settings()
    } catch (_: IllegalArgumentException) {
        Settings()
    }

    /**
     * Keeps [settings]; replaces what was kept only by a whole file.
     *
     * @throws IOException when it cannot be written.
     */
    fun write(settings: Settings) {
        Files.createDirectories(file.parent)
        val draft = Files.createTempFile(file.parent, "settings", ".json")
        try {
            Files.writeString(draft, json.encodeToString(Settings.serializer(), settings))
            Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING)
        } finally {
            Files.deleteIfExists(draft)
        }
    }
}
