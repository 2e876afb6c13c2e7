package badlog.release

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File

private const val ROBOT = """
#include <badlog/BadLog.h>

int main(int, char** arguments) {
    badlog::BadLog log = badlog::BadLog::Init(arguments[1]);
    double angle = 0;
    badlog::BadLog::CreateTopic("Arm/Angle", "deg", [&] { return angle; });
    log.FinishInitialization();
    for (; angle < 45; angle += 1.5) {
        log.UpdateTopics();
        log.Log();
    }
}
"""

class PortsProof : FunSpec({
    val folder = tempFolder()
    val wheel = "badlog-$VERSION-py3-none-any.whl"
    val library = "badlog-cpp-$VERSION-$PLATFORM.zip"

    test("the wheel installs without a network, and reads a log").config(enabledOrReasonIf = ifMade(wheel) and CleanMachine.IF_POSSIBLE) {
        val python = File(folder, "python/bin/python")
        val venv = run(ProcessBuilder("python3", "-m", "venv", "${python.parentFile.parentFile}"))
        withClue(venv.text) { venv.code shouldBe 0 }
        val machine = CleanMachine(File(folder, "python-machine"), listOf("sh"))
        val installed = machine.run(listOf("$python", "-m", "pip", "install", "-q", "--no-index", "--disable-pip-version-check", "${download(wheel)}"))
        withClue(installed.text) { installed.code shouldBe 0 }
        val script = "import badlog; print(badlog.__version__, min(badlog.read('$ROOT/samples/qualification-42.bag')['System/Battery Voltage'].samples))"
        machine.run(listOf("$python", "-c", script)).text shouldBe "$VERSION 6.73\n"
    }

    test("a robot in C++ is compiled against the library, and logs").config(enabledOrReasonIf = ifMade(library) and CleanMachine.IF_POSSIBLE) {
        val home = unpacked(download(library), File(folder, "cpp"))
        val robot = File(folder, "robot.cpp").apply { writeText(ROBOT) }
        val compiled = run(
            ProcessBuilder("c++", "-std=c++17", "-I$home/include", "$robot", "-L$home/lib", "-lbadlog", "-pthread", "-o", "$folder/robot"),
        )
        withClue(compiled.text) { compiled.code shouldBe 0 }
        val log = File(folder, "match.bag")
        CleanMachine(File(folder, "cpp-machine"), emptyList()).run(listOf("$folder/robot", "$log")).code shouldBe 0
        log.readText() shouldContain "43.500"
    }

    test("the sources in C++ are built by CMake alone").config(enabledOrReasonIf = ifMade(library)) {
        val sources = unpacked(download("badlog-cpp-$VERSION.zip"), File(folder, "cpp-sources"))
        val configured = run(ProcessBuilder("cmake", "-S", "$sources", "-B", "$folder/cpp-build", "-DCMAKE_BUILD_TYPE=Debug"))
        withClue(configured.text) { configured.code shouldBe 0 }
        File(sources, "reader").isDirectory shouldBe true
    }
})

private infix fun EnabledOrReasonIf.and(other: EnabledOrReasonIf): EnabledOrReasonIf = { test ->
    this(test).takeIf { !it.isEnabled } ?: other(test)
}
