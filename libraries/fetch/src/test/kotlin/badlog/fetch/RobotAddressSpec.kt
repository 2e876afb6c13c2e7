package badlog.fetch

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class RobotAddressSpec : FunSpec({
    fun names(robot: String) = RobotAddress.of(robot).map { "${it.logins.joinToString("+")}@$it" }

    test("a team's number stands for the addresses of a roboRIO, then of a Systemcore") {
        names("1014") shouldContainExactly listOf(
            "lvuser+systemcore@10.10.14.2",
            "lvuser@172.22.11.2",
            "lvuser@roboRIO-1014-frc.local",
            "systemcore@robot.local",
            "systemcore@172.26.0.1",
            "systemcore@172.27.0.1",
            "systemcore@172.30.0.1",
        )
    }

    test("no part of an address begins with zeros") {
        for ((team, address) in listOf("78" to "10.0.78.2", "5" to "10.0.5.2", "12345" to "10.123.45.2", "25599" to "10.255.99.2")) {
            RobotAddress.of(team).first().name shouldBe address
        }
    }

    test("an address stands for itself, with its user and port if there are any") {
        names("10.10.14.2") shouldContainExactly listOf("lvuser+systemcore@10.10.14.2")
        names("pit@robot.local:2222") shouldContainExactly listOf("pit@robot.local:2222")
        names("[fe80::1%eth0]:22") shouldContainExactly listOf("lvuser+systemcore@[fe80::1%eth0]")
        RobotAddress.of("10.10.14.2", user = "systemcore").single().logins.single().password shouldBe "systemcore"
        RobotAddress.of("1014", user = "me").first().logins.single().password shouldBe ""
    }

    test("text that is neither a team nor an address is refused in one sentence") {
        for (robot in listOf("0", "-1", "25600", "", "a b", "x:y", "host:99999", "../x", "a@b@c", "-host")) {
            shouldThrow<IllegalArgumentException> { RobotAddress.of(robot) }.message!! shouldContain "“$robot”"
        }
    }
})
