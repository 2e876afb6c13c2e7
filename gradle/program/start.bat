@echo off
rem Starts @program@ with its own Java, or else with that of JAVA_HOME or on the PATH. JAVA_OPTS gives Java more options.
setlocal
for %%i in ("%~dp0..") do set "home=%%~fi"
set "lib=%home%\lib"
set "java=java.exe"
if defined JAVA_HOME set "java=%JAVA_HOME%\bin\java.exe"
if exist "%home%\java\bin\java.exe" set "java=%home%\java\bin\java.exe"
where /q "%java%" 2>nul || if not exist "%java%" (
    echo @program@ needs Java 17 or newer, and %java% is not there: install it, or set JAVA_HOME. 1>&2
    exit /b 1
)
set "classes="
if exist "%lib%\@program@.jsa" set classes="-XX:SharedArchiveFile=%lib%\@program@.jsa"
rem A command that runs long is worth Java's better compiler.
set "long="
if "%~1"=="@long@" set "long=-XX:TieredStopAtLevel=4"
"%java%" @options@ %classes% %long% %JAVA_OPTS% -cp "@classpath@" @main@ %*
exit /b %errorlevel%
