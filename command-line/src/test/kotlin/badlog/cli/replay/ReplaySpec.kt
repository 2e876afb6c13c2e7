package badlog.cli.replay

import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonPrimitive
import java.net.InetAddress
import java.net.ServerSocket

class ReplaySpec : FunSpec({
    val match = SAMPLES.resolve("qualification-42.bag")

    test("a part of a log is served, and the program ends with it") {
        val ended = badlog("replay", match, "--port", "0", "--from", "10", "--to", "10.5", "--speed", "5", "--topic", "Odd = Nix")
        ended.code shouldBe ExitCode.WHOLE
        ended.out shouldContain "is served on port"
        ended.out shouldContain "only look at port 5810"
        ended.err shouldContain "“Nix” is not a topic"
    }

    test("a program gets the port, or the reason for a failure") {
        val json = badlogJson("replay", match, "--port", "0", "--from", "0:10", "--to", "10.5", "--speed", "5").json.single()
        json.getValue("command").jsonPrimitive.content shouldBe "replay"
        json.getValue("status").jsonPrimitive.content shouldBe "whole"
        json.getValue("port").jsonPrimitive.int shouldBeGreaterThan 0
        badlogJson("replay", "nix.bag").json.single().getValue("status").jsonPrimitive.content shouldBe "failed"
    }

    test("a range outside the log is reported with the log's range") {
        badlog("replay", match, "--port", "0", "--from", "100", "--to", "50").err.let { said ->
            said shouldContain "--from 100 comes after --to 50"
            said shouldContain "from 0 to 155.991"
        }
        badlog("replay", match, "--port", "0", "--from", "200").err shouldContain "has nothing from 200"
        badlog("replay", match, "--port", "0", "--from", "1:40", "--to", "50").code shouldBe ExitCode.NOTHING
    }

    test("plain CSV is replayed in the time of a topic") {
        val csv = SAMPLES.resolve("elevator-bench.csv")
        badlog("replay", csv, "--x", "Time", "--port", "0", "--to", "0.5", "--speed", "5").code shouldBe ExitCode.WHOLE
    }

    test("a port that is taken is reported, and two logs are a wrong usage") {
        ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { taken ->
            val ended = badlog("replay", match, "--port", taken.localPort.toString())
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain taken.localPort.toString()
        }
        badlog("replay", match, match).code shouldBe ExitCode.USAGE
    }
})
