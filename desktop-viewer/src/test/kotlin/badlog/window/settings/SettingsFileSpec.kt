package badlog.window.settings

import badlog.window.theme.Theme
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.io.IOException
import java.nio.file.Files

class SettingsFileSpec : FunSpec({
    val settings = Settings(Theme.DARK, listOf("/logs"), "Arm/Angle", 200, false, WindowPlace(1, 2, 800, 600, isMaximized = true))

    test("what is kept is read again, and replaced as a whole") {
        val folder = tempdir().toPath()
        val file = SettingsFile(folder.resolve("user/settings.json"))
        file.write(settings, Settings())
        file.read() shouldBe settings
        file.write(settings.copy(theme = Theme.LIGHT), settings)
        file.read().theme shouldBe Theme.LIGHT
        Files.list(folder.resolve("user")).use { it.count() } shouldBe 1
    }

    test("settings that are missing or damaged are as none; what a later version added is passed over") {
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

    test("of two windows each keeps what it changed, and no less of the other's") {
        val file = SettingsFile(tempdir().toPath().resolve("settings.json"))
        file.write(settings, Settings())
        file.write(settings.copy(theme = Theme.LIGHT).opened("/first"), settings)
        file.write(settings.copy(graphHeight = 120).opened("/second"), settings)
        file.read() shouldBe settings.copy(theme = Theme.LIGHT, graphHeight = 120, recentFolders = listOf("/second", "/logs", "/first"))
    }

    test("settings that cannot be written leave nothing behind") {
        val folder = tempdir().toPath()
        Files.createDirectories(folder.resolve("settings.json/in the way"))
        shouldThrow<IOException> { SettingsFile(folder.resolve("settings.json")).write(settings, Settings()) }
        Files.list(folder).use { it.count() } shouldBe 1
    }
})
