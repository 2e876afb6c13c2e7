package badlog.release

import com.fasterxml.jackson.databind.ObjectMapper
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File

class VersionsSpec : FunSpec({
    test("the ports to other languages have the version of gradle.properties") {
        File(ROOT, "ports/cpp/CMakeLists.txt").readText() shouldContain "project(badlog VERSION $VERSION "
        File(ROOT, "ports/python/src/badlog/_version.py").readText() shouldContain "\"$VERSION\""
    }

    test("a vendordep names this version, one season, and one library: the robot's logger, or its server") {
        val seasons = mapOf("" to ("frcYear" to "2026"), "2027" to ("wpilibYear" to "2027"))
        val libraries = mapOf("Badlog" to "badlog-robot", "BadlogWeb" to "badlog-web")
        for ((name, artifact, season) in libraries.flatMap { (name, artifact) -> seasons.map { (ending, season) -> Triple(name + ending, artifact, season) } }) {
            val json = ObjectMapper().readTree(File(ROOT, "vendordep/build/json/$name.json"))
            json["fileName"].asText() shouldBe "$name.json"
            json["name"].asText() shouldBe name.removeSuffix("2027")
            json["version"].asText() shouldBe VERSION
            json.fieldNames().asSequence().filter { it.endsWith("Year") }.toList() shouldBe listOf(season.first)
            json[season.first].asText() shouldBe season.second
            val library = json["javaDependencies"].single()
            listOf("groupId", "artifactId", "version").map { library[it].asText() } shouldBe listOf(property("badlog.group"), artifact, VERSION)
        }
    }

    test("while the project has no address, vendordeps name none") {
        val home = property("badlog.home")
        for (name in listOf("Badlog", "Badlog2027", "BadlogWeb", "BadlogWeb2027", "BadlogCpp", "BadlogCpp2027")) {
            val json = ObjectMapper().readTree(File(ROOT, "vendordep/build/json/$name.json"))
            json["mavenUrls"].isEmpty shouldBe home.isEmpty()
            json["jsonUrl"].asText() shouldBe if (home.isEmpty()) "" else "$home/releases/latest/download/$name.json"
        }
    }

    test("no guide points to an address of the project that does not exist") {
        val guides = File(ROOT, "docs").walk().filter { it.extension == "md" } + File(ROOT, "README.md") + File(ROOT, "ports/python/README.md")
        guides.filter { Regex("(github\\.com|githubusercontent\\.com)/badlog").containsMatchIn(it.readText()) }.map { it.name }.toList().shouldBeEmpty()
    }
})
