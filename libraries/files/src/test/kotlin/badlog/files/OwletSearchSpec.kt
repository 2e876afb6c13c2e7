package badlog.files

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.nio.file.Files
import java.nio.file.Path

/** A hoot log's first bytes: the bus, the firmware, the compliancy and a time. */
private fun hoot(bus: String, compliancy: Int): ByteArray = bus.encodeToByteArray().copyOf(64) + byteArrayOf(1, 2, 0, 0, 0, 0, compliancy.toByte(), 0) + ByteArray(4) { 9 } + ByteArray(100)

private fun Path.program(name: String): Path = resolve(name).also {
    Files.createDirectories(it.parent)
    Files.write(it, ByteArray(0))
    it.toFile().setExecutable(true)
}

class OwletSearchSpec : FunSpec({
    fun search(user: Path, system: String = "Linux", vararg variables: Pair<String, Any>) = OwletSearch(system, user) { name -> variables.toMap()[name]?.toString() }

    test("the header names the bus, and the converter that can read it") {
        inFolder { folder ->
            checkNotNull(HootHeader.of(Files.write(folder.resolve("a.hoot"), hoot("canivore", 12)))).run {
                bus shouldBe "canivore"
                compliancy shouldBe 12
                isTooOld shouldBe false
            }
            HootHeader.of(Files.write(folder.resolve("b.hoot"), ByteArray(70))) shouldBe null
            HootHeader.of(Files.write(folder.resolve("c.hoot"), ByteArray(200))) shouldBe null
        }
    }

    test("of several converters for the log's compliancy, the newest is used, wherever AdvantageScope keeps it") {
        for ((system, data) in listOf("Linux" to ".config", "Mac OS X" to "Library/Application Support", "Windows 11" to "AppData/Roaming")) {
            inFolder { home ->
                val owlets = home.resolve(data).resolve("AdvantageScope/owlet")
                val all = listOf("owlet-24.1.0-C8", "owlet-25.9.0-C12", "owlet-25.10.1-C12.exe", "owlet-26.0.0-C15", "owlet-26.0.0-C1").associateWith(owlets::program)
                search(home, system).programFor(12) shouldBe all["owlet-25.10.1-C12.exe"]
                search(home, system).programFor(8) shouldBe all["owlet-24.1.0-C8"]
                search(home, system).programFor(1) shouldBe all["owlet-26.0.0-C1"]
                search(home, system).programFor(13) shouldBe null
                search(home, system).any shouldBe all["owlet-26.0.0-C15"]
            }
        }
    }

    test("the setting comes first, then the converter for the log, then the PATH") {
        inFolder { home ->
            val path = home.resolve("bin").program("owlet")
            val own = home.resolve(".config/AdvantageScope/owlet").program("owlet-25.1.0-C12")
            val year = home.resolve("wpilib/2026/advantagescope/resources/owlet/linux").program("owlet-26.1.0-C15")
            val pathVariable = "PATH" to "${home.resolve("bin")}${File.pathSeparator}/nowhere"
            search(home, "Linux", pathVariable).programFor(12) shouldBe own
            search(home, "Linux", pathVariable).programFor(15) shouldBe year
            search(home, "Linux", pathVariable).programFor(14) shouldBe path
            search(home, "Linux", pathVariable, OwletSearch.SETTING to path).programFor(12) shouldBe path
            val others = home.resolve("mine").program("owlet-27.0.0-C12").parent
            search(home, "Linux", OwletSearch.SETTING to others).programFor(12) shouldBe others.resolve("owlet-27.0.0-C12")
            search(home.resolve("empty")).any shouldBe null
        }
    }

    test("without a converter, one sentence names the one that is needed, and its source") {
        inFolder { folder ->
            fun sentence(name: String, bytes: ByteArray) = shouldThrow<UnreadableFileException> { Owlet.programFor(Files.write(folder.resolve(name), bytes), search(folder)) }.message
            sentence("a.hoot", hoot("rio", 12)) shouldContain "owlet for its version C12; AdvantageScope downloads it"
            sentence("b.hoot", hoot("rio", 5)) shouldContain "was written before Phoenix 2024"
            sentence("c.hoot", ByteArray(9)) shouldContain "can only be read by CTRE's program owlet; AdvantageScope"
        }
    }
})
