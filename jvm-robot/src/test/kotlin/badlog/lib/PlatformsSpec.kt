package badlog.lib

import badlog.core.platform.Wine
import badlog.robots.ManagedRobot
import badlog.robots.RecordedScript
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldMatch
import java.io.File
import java.util.zip.GZIPInputStream

/** The logger on the machines of robots and of their programmers; `./gradlew :jvm-robot:platforms` runs it, not `check`. */
class PlatformsSpec : FunSpec({
    val wine = lazy { Wine() }
    afterSpec { if (wine.isInitialized()) wine.value.close() }

    for (platform in Platform.all) {
        val enabled = if (platform.isMissing) Enabled.disabled(platform.missing) else Enabled.enabled

        test("${platform.name}: a recorded script of calls gives the same bytes as here").config(enabledOrReasonIf = { enabled }) {
            inFolder { folder ->
                val file = File(folder, "script.bag")
                platform.runRobot({ wine.value }, RecordedScript::class.java, file.path).run { "$code $text" shouldBe "0 " }
                val recorded = checkNotNull(PlatformsSpec::class.java.getResource("/recorded-script.bag")).readBytes()
                file.readBytes() contentEquals recorded shouldBe true
            }
        }

        for (isCompressed in listOf(false, true)) {
            val kind = if (isCompressed) "gzipped" else "plain"

            test("${platform.name}: a $kind log gets the name of its match, and no row is lost").config(enabledOrReasonIf = { enabled }) {
                inFolder { folder ->
                    val logs = File(folder, "Größe")
                    platform.runRobot({ wine.value }, ManagedRobot::class.java, logs.path, "$isCompressed").run { "$code $text" shouldBe "0 " }
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
