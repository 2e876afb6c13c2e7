package badlog.lib

import badlog.robots.ManagedRobot
import badlog.robots.RecordedScript
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldMatch
import java.io.File
import java.util.zip.GZIPInputStream

/**
 * The Java of another machine, in an emulator.
 *
 * @property property the system property with the command that starts it, its words separated by line ends; the build sets it.
 * @property separator what separates the parts of its class path.
 */
private class Platform(val name: String, val property: String, val separator: String) {
    val command: List<String> = System.getProperty(property).orEmpty().lines().filter { it.isNotEmpty() }

    /** Why it is left out, if it is. */
    val missing: String = System.getProperty("$property.missing").orEmpty()

    fun run(program: Class<*>, vararg arguments: String): Pair<Int, String> {
        val classpath = listOf("badlog.shipped", "badlog.robots").flatMap { System.getProperty(it).split(File.pathSeparator) }
        if (property.endsWith("windows")) driveC
        return started(command + listOf("-cp", classpath.joinToString(separator), program.name) + arguments)
    }
}

/** Wine's own drive C:, which it makes, with many words, when it is first started. */
private val driveC: Pair<Int, String> by lazy { started(listOf("wine", "wineboot", "-i")) }

private fun started(command: List<String>): Pair<Int, String> {
    val process = ProcessBuilder(command).redirectErrorStream(true)
    // Quietly, without a browser and .NET, and with file names in UTF-8.
    process.environment() += mapOf(
        "WINEPREFIX" to System.getProperty("badlog.platforms.wine"),
        "WINEDEBUG" to "-all",
        "WINEDLLOVERRIDES" to "mscoree=;mshtml=",
        "LC_ALL" to "C.UTF-8",
    )
    val started = process.start()
    val said = started.inputStream.readBytes().decodeToString()
    return started.waitFor() to said
}

private val PLATFORMS = listOf(
    Platform("Windows (Wine)", "badlog.platforms.windows", ";"),
    Platform("64-bit ARM (qemu)", "badlog.platforms.arm64", ":"),
    Platform("Java 25 on 64-bit ARM, as on Systemcore (qemu)", "badlog.platforms.systemcore", ":"),
    Platform("32-bit ARM (qemu)", "badlog.platforms.armhf", ":"),
)

/** The logger on the machines of robots and of their programmers; `./gradlew :jvm-robot:platforms` runs it, not `check`. */
class PlatformsSpec : FunSpec({
    for (platform in PLATFORMS) {
        val enabled = if (platform.command.isEmpty()) Enabled.disabled(platform.missing) else Enabled.enabled

        test("${platform.name}: a recorded script of calls gives the same bytes as here").config(enabledOrReasonIf = { enabled }) {
            inFolder { folder ->
                val file = File(folder, "script.bag")
                platform.run(RecordedScript::class.java, file.path).let { (code, said) -> "$code $said" shouldBe "0 " }
                val recorded = checkNotNull(PlatformsSpec::class.java.getResource("/recorded-script.bag")).readBytes()
                file.readBytes() contentEquals recorded shouldBe true
            }
        }

        for (isCompressed in listOf(false, true)) {
            val kind = if (isCompressed) "gzipped" else "plain"

            test("${platform.name}: a $kind log gets the name of its match, and no row is lost").config(enabledOrReasonIf = { enabled }) {
                inFolder { folder ->
                    val logs = File(folder, "Größe")
                    platform.run(ManagedRobot::class.java, logs.path, "$isCompressed").let { (code, said) -> "$code $said" shouldBe "0 " }
                    val file = logs.listFiles()!!.single()
                    file.name shouldMatch "FRC_\\d{8}_\\d{6}_OHCL_Q42\\.bag(\\.gz)?"
                    val bytes = if (isCompressed) GZIPInputStream(file.inputStream()).use { it.readBytes() } else file.readBytes()
                    val recording = recordingIn(bytes)
                    val rows = recording.topics.single { it.name == "Row" }.samples.map { it.toLong() }
                    rows shouldBe (rows.first()..rows.last()).toList()
                    recording.topics.single { it.name == "Robot/Events" }.texts.dictionary shouldContain "Match OHCL Q42"
                }
            }
        }
    }
})
