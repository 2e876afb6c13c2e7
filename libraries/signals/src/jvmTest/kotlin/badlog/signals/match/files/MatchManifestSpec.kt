package badlog.signals.match.files

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class MatchManifestSpec : FunSpec({
    test("a written manifest is read back unchanged") {
        val files = listOf(StatedFile("robot \"1\".wpilog", FileRole.ROBOT, 0.0), StatedFile("ds/ä.dslog", FileRole.STATION, -12.25), StatedFile("x.csv", null, null))
        MatchManifest.of(MatchManifest(files).text()).files.map { Triple(it.name, it.role, it.seconds) } shouldBe files.map { Triple(it.name, it.role, it.seconds) }
    }

    test("a byte order mark and members that are null are ignored") {
        val text = "\uFEFF{\"version\":1,\"files\":[{\"name\":\"a\",\"role\":null,\"seconds\":null,\"error\":null}]}"
        MatchManifest.of(text).files.single().run { listOf(name, role, seconds, error) } shouldBe listOf("a", null, null, null)
    }

    test("a mistake is reported in a sentence") {
        fun said(text: String) = shouldThrow<MatchManifestException> { MatchManifest.of(text) }.message
        for (text in listOf("", "[]", "{}", "{\"version\":1,\"files\":[3]}", "{\"version\":1,\"files\":{}}", "{\"version\":1,\"files\":[{\"role\":\"robot\"}]}")) {
            said(text) shouldContain "cannot be read"
        }
        said("{\"version\":2,\"files\":[]}") shouldContain "newer"
        for (name in listOf("../a.bag", "/a.bag", "a/../b", "C:a", "a\\\\b", "", "a//b", "a\\u0000")) {
            said("{\"version\":1,\"files\":[{\"name\":\"$name\"}]}") shouldContain "outside its folder"
        }
        said("{\"version\":1,\"files\":[{\"name\":\"a\",\"role\":\"pilot\"}]}") shouldContain "roles are robot, driver station"
        said("{\"version\":1,\"files\":[{\"name\":\"a\",\"seconds\":1e300}]}") shouldContain "not a number of seconds"
        said("{\"version\":1,\"files\":[{\"name\":\"a\"},{\"name\":\"A\"}]}") shouldContain "twice"
    }

    test("a match.json of another program is not a manifest, and one with mistakes is") {
        for (text in listOf("{}", "", "[]", "{\"key\":\"2026test_qm4\",\"alliances\":{\"red\":{\"score\":3}}}", "{\"version\":1}", "{\"a\":{\"version\":1,\"files\":[]}}")) {
            MatchManifest.isOne(text) shouldBe false
        }
        for (text in listOf("{\"version\":2,\"files\":{}}", "\uFEFF{\"files\":[3],\"version\":1}", "{\"version\":1,\"files\":[", MatchManifest(emptyList()).text())) {
            MatchManifest.isOne(text) shouldBe true
        }
    }

    test("no text ends in anything but a manifest or a sentence") {
        checkAll(Arb.string(0..60)) { text ->
            for (tried in listOf(text, "{\"version\":1,\"files\":[$text]}", "{\"version\":1,\"files\":[{\"name\":\"$text\",\"seconds\":$text}]}")) {
                try {
                    MatchManifest.of(tried).files.all { isNameInside(it.name) } shouldBe true
                } catch (e: MatchManifestException) {
                    e.message.isNotEmpty() shouldBe true
                }
            }
        }
    }
})
