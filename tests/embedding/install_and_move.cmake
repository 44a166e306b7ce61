# SPDX-License-Identifier: MIT
file(REMOVE_RECURSE ${INSTALLED} ${MOVED})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${INSTALLED}
                COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${INSTALLED} ${MOVED})
