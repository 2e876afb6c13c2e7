package badlog.cli.info

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.with
import badlog.cli.wpilog
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.createDirectories
import kotlin.io.path.div

class FilesBesideSpec : FunSpec({
    test("info lists the files of devices and cameras of the same match, in neighbor folders, too") {
        inFolder { folder ->
            val logs = (folder / "day/logs").createDirectories()
            val log = logs.wpilog("FRC_20260307_100000_MILLC_Q42.wpilog", listOf(Logged("/Arm", "double", "", List(200) { it.toDouble() to 1.0 })))
            logs.with("REV_20260307_100010.revlog", "")
            (folder / "day/hoot").createDirectories().run {
                with("rio_2026-03-07_09-59-50.hoot", "")
                with("rio_2026-03-07_10-20-00.hoot", "")
            }
            (folder / "day/videos").createDirectories().run {
                with("Q42.mp4", "")
                with("Q43.mp4", "")
                with("Q42.txt", "")
            }
            badlog("info", log).out.replace(Regex("\\s+"), " ") shouldContain
                "beside ../hoot/rio_2026-03-07_09-59-50.hoot (can bus), ../videos/Q42.mp4 (video), REV_20260307_100010.revlog (motors)"
            badlogJson("info", log).json.single().getValue("beside").jsonArray.map { file ->
                file.jsonObject.mapValues { it.value.jsonPrimitive.content }
            } shouldBe listOf(
                mapOf("path" to "../hoot/rio_2026-03-07_09-59-50.hoot", "role" to "can bus"),
                mapOf("path" to "../videos/Q42.mp4", "role" to "video"),
                mapOf("path" to "REV_20260307_100010.revlog", "role" to "motors"),
            )
            // A match has its files in itself.
            val match = logs / "FRC_20260307_100000_MILLC_Q42.zip"
            badlog("merge", log, logs.wpilog("eye.wpilog", listOf(Logged("/Eye", "double", "", listOf(0.0 to 1.0)))), "--offset", "eye.wpilog=0", "--offset", "${log.fileName}=0", "-o", match)
            badlogJson("info", match).json.single().run { containsKey("topics") to containsKey("beside") } shouldBe (true to false)
            val alone = logs.wpilog("other.wpilog", listOf(Logged("/Arm", "double", "", listOf(0.0 to 1.0))))
            badlog("info", alone).out shouldNotContain "beside"
            badlogJson("info", alone).json.single().keys.contains("beside") shouldBe false
        }
    }
})
