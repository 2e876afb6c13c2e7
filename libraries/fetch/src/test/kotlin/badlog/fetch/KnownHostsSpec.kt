package badlog.fetch

import badlog.files.UnwritableFileException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.nio.file.Files

class KnownHostsSpec : FunSpec({
    val robot = RobotAddress.of("10.10.14.2").single()

    test("a key that cannot be stored is an error, or is trusted until the program ends if the caller wants that") {
        val file = Files.createFile(tempdir().toPath().resolve("home")).resolve("known_hosts")
        shouldThrow<UnwritableFileException> { KnownHosts(file).trust(robot, "ssh-rsa one") }
        val notStored = ArrayList<UnwritableFileException>()
        val hosts = KnownHosts(file) { notStored += it }
        hosts.trust(robot, "ssh-rsa one")
        notStored.single().file shouldBe file
        hosts.knows("ssh-rsa one") shouldBe true
        hosts.hasOther(robot) shouldBe true
        hosts.knows("ssh-rsa other") shouldBe false
        KnownHosts(file).knows("ssh-rsa one") shouldBe false
    }
})
