package badlog.cli.convert

import badlog.cli.ExitCode
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.inFolder
import badlog.file.readRecording
import badlog.wpilog.WpilogWriter
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.div
import kotlin.io.path.outputStream

class ConvertWpilogSpec : FunSpec({
    test("a WPILOG becomes rows of the period asked for; what needs rows says how to get them") {
        inFolder { folder ->
            val log = folder / "match.wpilog"
            log.outputStream().use { out ->
                WpilogWriter(readRecording(SAMPLES.resolve("practice.bag"))).write { bytes, size -> out.write(bytes, 0, size) }
            }
            badlog("info", log).out shouldContain "samples"
            badlog("convert", "--to", "bag", "--period", "0.5", "--out", folder / "rows.bag", log).code shouldBe ExitCode.WHOLE
            readRecording(folder / "rows.bag").rowCount shouldBe 91
            val ended = badlog("cut", log, "--from", "1", "--to", "2")
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "badlog convert --to bag"
        }
    }
})
