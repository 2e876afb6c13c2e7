package badlog.window.settings

import badlog.window.theme.Theme
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CyclicBarrier
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

class SettingsFileSpec : FunSpec({
    val settings = Settings(Theme.DARK, listOf("/logs"), "Arm/Angle", 200, false, WindowPlace(1, 2, 800, 600, isMaximized = true))

    fun namesIn(folder: Path): List<String> = Files.list(folder).use { files -> files.map { "${it.fileName}" }.toList() }

    test("stored settings are read again, and replaced as a whole") {
        val folder = tempdir().toPath()
        val file = SettingsFile(folder.resolve("user/settings.json"))
        file.write(settings, Settings())
        file.read() shouldBe settings
        file.write(settings.copy(theme = Theme.LIGHT), settings)
        file.read().theme shouldBe Theme.LIGHT
        namesIn(folder.resolve("user")) shouldContainExactlyInAnyOrder listOf("settings.json", ".badlog.lock")
    }

    test("missing or damaged settings are the defaults; unknown keys of a later version are ignored") {
        val path = tempdir().toPath().resolve("settings.json")
        val file = SettingsFile(path)
        file.read() shouldBe Settings()
        for (damaged in listOf("", "{", "[]", "null", "{\"window\": 3}", "{\"graphHeight\": 1e99}", "[".repeat(100_000))) {
            Files.writeString(path, damaged)
            file.read() shouldBe Settings()
        }
        Files.write(path, ByteArray(300) { (it * 37).toByte() })
        file.read() shouldBe Settings()
        Files.writeString(path, """{"theme": "PINK", "graphHeight": 90, "sound": {"volume": [11]}}""")
        file.read() shouldBe Settings(graphHeight = 90)
    }

    test("each of two windows keeps its own changes, and the other's") {
        val file = SettingsFile(tempdir().toPath().resolve("settings.json"))
        file.write(settings, Settings())
        file.write(settings.copy(theme = Theme.LIGHT).opened("/first"), settings)
        file.write(settings.copy(graphHeight = 120).opened("/second"), settings)
        file.read() shouldBe settings.copy(theme = Theme.LIGHT, graphHeight = 120, recentFolders = listOf("/second", "/logs", "/first"))
    }

    test("two windows that write at the same moment keep each other's changes") {
        val file = SettingsFile(tempdir().toPath().resolve("settings.json"))
        val moment = CyclicBarrier(2)

        fun window(change: Settings.(Int) -> Settings) = thread {
            (0..30).map { settings.change(it) }.zipWithNext { before, changed ->
                moment.await(1, TimeUnit.MINUTES)
                file.write(changed, before)
            }
        }
        file.write(settings, Settings())
        listOf(window { copy(graphHeight = 100 + it) }, window { copy(theme = Theme.entries[it % 2]) }).forEach { it.join() }
        file.read() shouldBe settings.copy(graphHeight = 130, theme = Theme.entries[0])
    }

    test("settings that cannot be written leave no files behind") {
        val folder = tempdir().toPath()
        Files.createDirectories(folder.resolve("settings.json/in the way"))
        shouldThrow<IOException> { SettingsFile(folder.resolve("settings.json")).write(settings, Settings()) }
        namesIn(folder) shouldContainExactlyInAnyOrder listOf("settings.json", ".badlog.lock")
    }
})
