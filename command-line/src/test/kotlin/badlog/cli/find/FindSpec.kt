package badlog.cli.find

import badlog.cli.BAG
import badlog.cli.ExitCode
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.inFolder
import badlog.cli.with
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.div
import kotlinx.serialization.json.Json

class FindSpec : FunSpec({
    val samples = SAMPLES

    test("the matches in which it holds are told with time and value") {
        val ended = badlog("find", samples, "min(System/Battery Voltage) < 7", "--no-cache")
        ended.code shouldBe ExitCode.WHOLE
        ended.out shouldContain "93.7096 s  6.73 V"
        ended.out shouldContain "Found in 1 of 4 logs."
    }

    test("a mistake in the question is pointed at, and is a wrong usage") {
        val ended = badlog("find", samples / "practice.bag", "min(System/Battery Voltage) < ", "--no-cache")
        ended.code shouldBe ExitCode.USAGE
        ended.err shouldContain "^"
    }

    test("programs get JSON; a log that is missing counts as left out") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val ended = badlog("find", log, folder / "nix.bag", "1 < 2", "--no-cache", "--json")
            ended.code shouldBe ExitCode.SALVAGED
            Json.parseToJsonElement(ended.out)
            ended.err shouldContain "nix.bag"
        }
    }

    test("a question may use topics that are calculated") {
        val power = "Power [W] = System/Battery Voltage * PDP/Total Current"
        val ended = badlog("find", samples, "max(Power) > 2000", "--topic", power, "--no-cache")
        ended.code shouldBe ExitCode.WHOLE
        ended.out shouldContain "2708.3 W"
    }

    test("where no log can be given the topic, its definition is pointed at") {
        val ended = badlog("find", samples, "max(Power) > 2000", "--topic", "Power = Volage * 2", "--no-cache")
        ended.code shouldBe ExitCode.USAGE
        ended.err shouldContain "Power = Volage * 2\n        ^^^^^^"
    }
})
