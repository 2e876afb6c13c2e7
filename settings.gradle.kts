pluginManagement {
    repositories {
        mavenCentral()
        gradlePluginPortal()
    }
}

dependencyResolutionManagement {
    repositories {
        mavenCentral()
        google {
            content {
                includeGroupByRegex("androidx\\..*")
            }
        }
    }
}

rootProject.name = "badlog"

include(":core")
include(":jvm-robot")
include(":protocol")
include(":exporter")
include(":page")
include(":command-line")
include(":desktop-viewer")

include(":assistant")
include(":catalog")
include(":charts")
include(":expression")
include(":fetch")
include(":files")
include(":formats")
include(":networktables")
include(":rules")
include(":report")
include(":season")
include(":signals")
include(":spark")
include(":viewer")
include(":web")

include(":cpp")
include(":python")

include(":samples")
include(":architecture")
include(":fuzzing")
include(":release")
include(":vendordep")
include(":site")
include(":benchmarks")

project(":architecture").projectDir = file("gradle/architecture")
project(":assistant").projectDir = file("libraries/assistant")
project(":catalog").projectDir = file("libraries/catalog")
project(":charts").projectDir = file("libraries/charts")
project(":cpp").projectDir = file("ports/cpp")
project(":expression").projectDir = file("libraries/expression")
project(":exporter").projectDir = file("html-export/exporter")
project(":fetch").projectDir = file("libraries/fetch")
project(":files").projectDir = file("libraries/files")
project(":fuzzing").projectDir = file("gradle/fuzzing")
project(":formats").projectDir = file("libraries/formats")
project(":networktables").projectDir = file("libraries/networktables")
project(":page").projectDir = file("html-export/page")
project(":protocol").projectDir = file("html-export/protocol")
project(":python").projectDir = file("ports/python")
project(":rules").projectDir = file("libraries/rules")
project(":release").projectDir = file("gradle/release")
project(":report").projectDir = file("libraries/report")
project(":season").projectDir = file("libraries/season")
project(":signals").projectDir = file("libraries/signals")
project(":site").projectDir = file("gradle/site")
project(":spark").projectDir = file("libraries/season/spark")
project(":viewer").projectDir = file("libraries/viewer")
project(":web").projectDir = file("jvm-robot/web")
