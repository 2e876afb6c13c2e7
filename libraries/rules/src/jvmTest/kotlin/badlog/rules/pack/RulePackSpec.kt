package badlog.rules.pack

import badlog.rules.RuleSet
import badlog.rules.toJson
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import java.io.File
import java.nio.file.Files
import java.nio.file.Path

/** Symbolic links: on Windows only administrators make them. */
private val IF_LINKS =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows makes symbolic links for administrators only")

private const val RULES = "badlog-rules.toml"

private fun problemOf(pack: Path): String = shouldThrow<PackException> { RulePack.open(pack).close() }.message

class RulePackSpec : FunSpec({
    val whole = arrayOf(
        RULES to ruleText("Jammed"),
        "badlog-signals.toml" to "[[signal]]\nname = \"hood angle\"\ntopics = [\"Hood\"]\n",
        "can_map.json" to "[{\"id\": 3, \"name\": \"Front left\", \"subsystem\": \"Drive\"}]",
        "fires/Jammed/a.bag" to "one",
        "silent/Jammed/b.wpilog" to "two",
        "README.md" to "Ours.",
        ".DS_Store" to "x",
        "tool.py" to "print()",
    )

    test("a folder, its zip, and a zip with the folder in it are the same pack") {
        val folder = tempdir().toPath()
        val pack = folder.packFolder("a", *whole)
        val packs = listOf(pack, zipped(pack, folder.resolve("b.zip")), zipped(pack, folder.resolve("c.zip"), isOuter = true))
        val read = packs.map { path ->
            RulePack.open(path).use { listOf(it.withBuiltIn.toJson(), it.slices.map { slice -> slice.name to it.bytesOf(slice).decodeToString() }, it.ignored) }
        }
        read.distinct().size shouldBe 1
        RulePack.open(pack).use { opened ->
            opened.rules.rules.map { it.name } shouldBe listOf("Jammed")
            opened.slices.map { Triple(it.name, it.isFiring, it.folder) } shouldContainExactly
                listOf(Triple("fires/Jammed/a.bag", true, "Jammed"), Triple("silent/Jammed/b.wpilog", false, "Jammed"))
            opened.ignored shouldBe listOf("tool.py")
            opened.rules.devices.devices.single().name shouldBe "Front left"
            (opened.withBuiltIn.rules.size > opened.rules.rules.size) shouldBe true
            (opened.rules.signals.find("hood angle") != null) shouldBe true
        }
    }

    test("a pack is data: programs, and changes to the rules of others, are refused in its rules") {
        val folder = tempdir().toPath()
        for (text in listOf("[[hook]]\ncommand = \"x\"\n", "extends = \"default\"\n", "off = [\"power\"]\n", "[limits]\n\"Low battery\" = { volts = 1 }\n")) {
            problemOf(folder.packFolder("p", RULES to text)) shouldContain "is not a key of a pack's rules; the keys are aliases, rule, cause, leads_to."
        }
    }

    test("a mistake in a file of a pack is reported with the file, the pack and the place") {
        val folder = tempdir().toPath()
        val pack = folder.packFolder("p", RULES to ruleText("A").replace("warning", "bad"))
        problemOf(pack).lines()[0] shouldBe "badlog-rules.toml in $pack: Line 3: A severity is “error”, “warning” or “note”, not “bad”."
        problemOf(folder.packFolder("q", RULES to ruleText("A"), "can_map.json" to "[")) shouldContain "can_map.json in ${folder.resolve("q")}: It is not JSON"
        problemOf(folder.packFolder("r", "a.txt" to "x")) shouldContain "has no badlog-rules.toml"
        problemOf(folder.resolve("none")) shouldContain "There is no pack"
    }

    test("no link is followed, wherever it leads").config(enabledOrReasonIf = { IF_LINKS }) {
        val folder = tempdir().toPath()
        val secret = Files.writeString(folder.resolve("secret.toml"), ruleText("Secret"))
        val pack = folder.packFolder("p", RULES to ruleText("A"))
        Files.createSymbolicLink(pack.resolve("badlog-signals.toml"), secret)
        problemOf(pack) shouldContain "“badlog-signals.toml” in $pack is a link; copy into the pack what it leads to."
        Files.delete(pack.resolve("badlog-signals.toml"))
        Files.createSymbolicLink(pack.resolve("fires"), folder)
        problemOf(pack) shouldContain "“fires” in $pack is a link"
        problemOf(Files.createSymbolicLink(folder.resolve("q"), pack)) shouldContain "is a link; name the pack itself"
    }

    test("a name that leads out of a zip, or that two files share, is refused") {
        val folder = tempdir().toPath()
        val rules = RULES to ruleText("A").encodeToByteArray()
        val odd = listOf("../x", "/etc/x", "a/../../x", "C:/x", "a\\b", "./x", "a//b", "a\u0000b", "1/2/3/4/5/6.bag")
        for (name in odd) problemOf(folder.packZip("p.zip", rules, name to byteArrayOf(1))) shouldContain "in ${folder.resolve("p.zip")} is "
        problemOf(folder.packZip("p.zip", rules, "fires/A/x.bag" to byteArrayOf(1), "fires/a/X.bag" to byteArrayOf(2))) shouldContain
            "has two files called “fires/a/X.bag”"
    }

    test("a zip that grows without end, has too many files or is not a zip is refused") {
        val folder = tempdir().toPath()
        val rules = RULES to ruleText("A").encodeToByteArray()
        problemOf(folder.packZip("p.zip", rules, "fires/A/x.bag" to ByteArray(8 shl 20))) shouldContain "grows more than 200 times"
        problemOf(folder.packZip("p.zip", rules, "fires/A/x.bag" to ByteArray((32 shl 20) + 1))) shouldContain "is larger than 32 MB"
        problemOf(folder.packZip("p.zip", rules, *Array(1001) { "fires/A/$it.bag" to byteArrayOf() })) shouldContain "has more than 1000 files"
        problemOf(Files.writeString(folder.resolve("n.zip"), "not a zip")) shouldContain "is not a zip that can be read"
        problemOf(Files.write(folder.resolve("e.zip"), byteArrayOf())) shouldContain "is not a zip that can be read"
    }

    test("a folder with too much in it is refused") {
        val folder = tempdir().toPath()
        problemOf(folder.packFolder("p", RULES to ruleText("A"), *Array(1000) { "fires/A/$it.bag" to "" })) shouldContain "has more than 1000 files"
        problemOf(folder.packFolder("q", RULES to ruleText("A"), "fires/A/b/c/d.bag" to "")) shouldContain "is nested too deeply"
    }

    test("a compressed slice is refused, since its size does not show the memory that it takes") {
        val folder = tempdir().toPath()
        val pack = folder.packFolder("p", RULES to ruleText("A"), "fires/A/x.bag" to "\u001f")
        Files.write(pack.resolve("fires/A/x.bag"), byteArrayOf(0x1F, 0x8B.toByte(), 8))
        RulePack.open(pack).use { shouldThrow<PackException> { it.bytesOf(it.slices.single()) }.message shouldContain "is compressed; put the log itself there" }
    }

    test("any change of a zip's bytes makes a pack, or one sentence, never a crash") {
        val folder = tempdir().toPath()
        val original = Files.readAllBytes(zipped(folder.packFolder("p", *whole), folder.resolve("whole.zip")))
        val changed = folder.resolve("changed.zip")
        checkAll(Arb.list(Arb.int(original.indices), 1..6), Arb.byteArray(Arb.int(6..6), Arb.byte())) { places, values ->
            val bytes = original.copyOf()
            places.forEachIndexed { i, place -> bytes[place] = values[i] }
            Files.write(changed, bytes)
            isReadOrRefused(changed) shouldBe true
            Files.write(changed, original.copyOf(places[0]))
            isReadOrRefused(changed) shouldBe true
        }
    }

    test("any names in a zip make a pack, or one sentence, and all that is read lies in its folders") {
        val folder = tempdir().toPath()
        val pieces = Arb.list(Arb.element("..", ".", "", "fires", "silent", "A", "a.bag", "\\", "C:", "\u0001", "~"), 1..6)
        checkAll(Arb.list(pieces, 0..5)) { names ->
            val files = names.map { it.joinToString("/") }.filter { it != RULES }.distinct().map { it.ifEmpty { "x" } to byteArrayOf(1) }.distinctBy { it.first }
            val zip = folder.packZip("names.zip", RULES to ruleText("A").encodeToByteArray(), *files.toTypedArray())
            try {
                RulePack.open(zip).use { pack ->
                    pack.slices.none { ".." in it.name || it.name.startsWith("/") } shouldBe true
                    pack.slices.forEach(pack::bytesOf)
                }
            } catch (e: PackException) {
                e.message.lines().size shouldBe 1
            }
        }
    }
})

private fun isReadOrRefused(zip: Path): Boolean = try {
    RulePack.open(zip).use { pack -> pack.slices.forEach(pack::bytesOf) }
    true
} catch (e: PackException) {
    e.message.isNotEmpty()
}
