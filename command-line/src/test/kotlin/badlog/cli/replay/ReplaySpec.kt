package badlog.cli.replay

import badlog.cli.ExitCode
import badlog.cli.SAMPLES
import badlog.cli.badlog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.net.InetAddress
import java.net.ServerSocket

class ReplaySpec : FunSpec({
    val match = SAMPLES.resolve("qualification-42.bag")

    test("a part of a log is served, and the program ends with it") {
        val ended = badlog("replay", match, "--port", "0", "--from", "10", "--to", "10.5", "--speed", "5", "--topic", "Odd = Nix")
        ended.code shouldBe ExitCode.WHOLE
        ended.out shouldContain "is served on port"
        ended.err shouldContain "There is no topic “Nix”"
    }

    test("a port that is taken is told, and two logs are a wrong usage") {
        ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { taken ->
            val ended = badlog("replay", match, "--port", taken.localPort.toString())
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain taken.localPort.toString()
        }
        badlog("replay", match, match).code shouldBe ExitCode.USAGE
    }
})
