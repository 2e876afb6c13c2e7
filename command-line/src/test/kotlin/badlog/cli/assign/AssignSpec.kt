package badlog.cli.assign

import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.names
import badlog.cli.with
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.div
import kotlin.io.path.readText

private const val HEADER = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Power/My Volts","unit":"V"},{"name":"Arm","unit":"m"}],"values":[]}"""
private val LOG = HEADER + "\nTime,Power/My Volts,Arm\n" + (0..60).joinToString("") { "${it / 10.0},${if (it in 20..40) 6 else 12},1\n" }

class AssignSpec : FunSpec({
    test("an assigned topic is the signal in all logs of the folder, for questions and rules") {
        inFolder { folder ->
            val log = folder.with("a.bag", LOG)
            val other = folder.with("b.bag", LOG)
            badlog("report", log).out shouldContain "say so with badlog assign"
            badlog("find", other, "min(battery) < 7").code shouldBe ExitCode.USAGE
            val assigned = badlog("assign", log, "battery", "Power/My Volts")
            assigned.code shouldBe ExitCode.WHOLE
            assigned.out shouldContain "“battery” is “Power/My Volts” in all logs of $folder, as "
            badlog("find", other, "min(battery) < 7").code shouldBe ExitCode.WHOLE
            badlog("report", other).out shouldContain "The battery voltage dropped to 6 V"
        }
    }

    test("programs learn which file names the signal") {
        inFolder { folder ->
            val assigned = badlogJson("assign", folder.with("a.bag", LOG), "battery", "Power/My Volts").json.single()
            assigned.getValue("output").jsonPrimitive.content shouldBe "${folder / "badlog-signals.toml"}"
            assigned.getValue("topic").jsonPrimitive.content shouldBe "Power/My Volts"
        }
    }

    test("a file of signals in a folder above is reported if a new file hides it") {
        inFolder { folder ->
            val above = folder.with("badlog-signals.toml", "[[signal]]\nname = \"hood\"\ntopics = \"Arm\"\n")
            val log = folder.with("event/a.bag", LOG)
            badlog("assign", log, "battery", "Power/My Volts").err shouldContain "$above also names signals."
            badlog("assign", log, "battery", "Power/My Volts").err shouldBe ""
        }
    }

    test("a person's file stays as it is, with the new topic first") {
        inFolder { folder ->
            val file = folder.with("badlog-signals.toml", "# ours\n[[signal]]\nname = \"battery\"\ntopics = \"Old\" # before\n")
            badlog("assign", folder.with("a.bag", LOG), "battery", "Power/My Volts").code shouldBe ExitCode.WHOLE
            file.readText() shouldBe "# ours\n[[signal]]\nname = \"battery\"\ntopics = [\"Power/My Volts\", \"Old\"] # before\n"
        }
    }

    test("a refusal is JSON, too") {
        inFolder { folder ->
            badlogJson("assign", folder.with("a.bag", LOG), "batery", "Power/My Volts").run {
                code shouldBe ExitCode.NOTHING
                err shouldBe ""
                json.single().getValue("status").jsonPrimitive.content shouldBe "failed"
                json.single().getValue("error").jsonPrimitive.content shouldContain "did you mean"
            }
        }
    }

    test("an impossible assignment is refused with a sentence, and nothing is written") {
        inFolder { folder ->
            val log = folder.with("a.bag", LOG)
            fun refused(signal: String, topic: String) = badlog("assign", log, signal, topic).run {
                code shouldBe ExitCode.NOTHING
                err
            }
            refused("batery", "Power/My Volts") shouldContain "“batery” is not a signal; did you mean “battery”"
            refused("battery", "Power/My Vots") shouldContain "“Power/My Vots” is not a topic of $log; did you mean “Power/My Volts”?"
            refused("battery", "Arm") shouldContain "“Arm” cannot be “battery”, which is a number in V; choose another topic."
            badlog("assign", folder, "battery", "Arm").err shouldContain "$folder is a folder, not a file; name a file in it."
            folder.names() shouldContainExactly listOf("a.bag")
        }
    }
})
